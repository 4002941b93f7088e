#include <csignal>

__attribute__((constructor)) static void crash() { std::raise(SIGSEGV); }
