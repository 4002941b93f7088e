extern "C" int no_library_has_this_function();

__attribute__((constructor)) static void call() { no_library_has_this_function(); }
