#include "browser.hpp"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <stdexcept>
#include <thread>

namespace stope::testing {
namespace {

using Json = nlohmann::json;

constexpr double kPatience = 60;  // seconds; a loaded machine starts a browser slowly

std::vector<unsigned char> from_base64(const std::string& text) {
  std::vector<unsigned char> bytes;
  unsigned held = 0;
  int bits = 0;
  for (const char c : text) {
    const std::size_t value =
        std::string("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/").find(c);
    if (value == std::string::npos) continue;
    held = held << 6 | static_cast<unsigned>(value);
    bits += 6;
    if (bits >= 8) {
      bits -= 8;
      bytes.push_back(static_cast<unsigned char>(held >> bits));
      held &= (1U << bits) - 1;
    }
  }
  return bytes;
}

std::string quoted(const std::string& text) { return Json(text).dump(); }

}  // namespace

Browser::Browser(const std::filesystem::path& folder)
    : folder_(std::filesystem::absolute(folder)), pipe_(folder_) {
  const Json page = call("Target.createTarget", {{"url", "about:blank"}});
  const Json attached =
      call("Target.attachToTarget", {{"targetId", page["targetId"]}, {"flatten", true}});
  std::filesystem::create_directories(folder_ / "downloads");
  call("Browser.setDownloadBehavior",
       {{"behavior", "allow"}, {"downloadPath", (folder_ / "downloads").string()}});
  session_ = attached["sessionId"];
  for (const char* part : {"Page.enable", "Runtime.enable", "Log.enable", "Network.enable"})
    call(part);
}

Json Browser::call(const std::string& method, Json parameters) {
  Json request{{"id", ++last_id_}, {"method", method}, {"params", std::move(parameters)}};
  if (!session_.empty()) request["sessionId"] = session_;
  pipe_.send(request.dump());
  for (;;) {
    const std::string text = pipe_.receive(kPatience);
    if (text.empty()) throw std::runtime_error("the browser did not answer " + method);
    const Json answer = Json::parse(text);
    if (!answer.contains("id")) {
      note(answer);
    } else if (answer["id"] == last_id_) {
      if (answer.contains("error"))
        throw std::runtime_error(method + ": " + answer["error"].dump());
      return answer["result"];
    }
  }
}

void Browser::note(const Json& event) {
  const std::string method = event.value("method", "");
  const Json parameters = event.value("params", Json::object());
  events_.push_back(method);
  if (method == "Runtime.exceptionThrown") {
    complaints_.push_back("exception: " + parameters["exceptionDetails"].dump());
  } else if (method == "Runtime.consoleAPICalled") {
    if (parameters["type"] == "error" || parameters["type"] == "warning")
      complaints_.push_back("console: " + parameters["args"].dump());
  } else if (method == "Log.entryAdded") {
    if (parameters["entry"]["level"] == "error" || parameters["entry"]["level"] == "warning")
      complaints_.push_back("log: " + parameters["entry"]["text"].dump());
  } else if (method == "Network.requestWillBeSent") {
    const std::string address = parameters["request"]["url"];
    if (address.rfind("data:", 0) != 0 && address != page_address_)
      complaints_.push_back("asked for " + address);
  }
}

void Browser::wait_for(const std::string& event) {
  while (std::find(events_.begin(), events_.end(), event) == events_.end()) {
    const std::string text = pipe_.receive(kPatience);
    if (text.empty()) throw std::runtime_error("the browser never said " + event);
    note(Json::parse(text));
  }
}

void Browser::open(const std::filesystem::path& file, const View& view) {
  call("Emulation.setDeviceMetricsOverride", {{"width", view.width},
                                              {"height", view.height},
                                              {"deviceScaleFactor", 1},
                                              {"mobile", false}});
  const Json scheme{{"name", "prefers-color-scheme"}, {"value", view.dark ? "dark" : "light"}};
  call("Emulation.setEmulatedMedia", {{"features", Json::array({scheme})}});
  complaints_.clear();
  events_.clear();
  page_address_ = "file://" + std::filesystem::absolute(file).string();
  call("Page.navigate", {{"url", page_address_}});
  wait_for("Page.loadEventFired");
}

Json Browser::evaluate(const std::string& expression) {
  const Json answer =
      call("Runtime.evaluate",
           {{"expression", expression}, {"returnByValue", true}, {"awaitPromise", true}});
  if (answer.contains("exceptionDetails"))
    throw std::runtime_error(expression + ": " + answer["exceptionDetails"].dump());
  return answer["result"].value("value", Json());
}

WindowPoint Browser::middle_of(const std::string& selector) {
  const Json box = evaluate(
      "(() => { const node = document.querySelector(" + quoted(selector) +
      "); if (!node) return null; node.scrollIntoView({block: 'center', behavior: 'instant'});"
      "const box = node.getBoundingClientRect();"
      "return [box.left + box.width / 2, box.top + box.height / 2]; })()");
  if (box.is_null()) throw std::runtime_error("the page has no " + selector);
  return {box[0], box[1]};
}

void Browser::mouse(const char* type, WindowPoint at, int buttons) {
  // A move with the button down is a drag only if it says so in both fields.
  const bool hovers = std::string(type) == "mouseMoved" && buttons == 0;
  call("Input.dispatchMouseEvent", {{"type", type},
                                    {"x", at.x},
                                    {"y", at.y},
                                    {"button", hovers ? "none" : "left"},
                                    {"buttons", buttons},
                                    {"clickCount", 1}});
}

void Browser::click(WindowPoint at) { drag(at, at); }

void Browser::drag(WindowPoint from, WindowPoint to) {
  mouse("mouseMoved", from, 0);
  mouse("mousePressed", from, 1);
  for (int step = 1; step <= 8; ++step)
    mouse("mouseMoved", {from.x + step * (to.x - from.x) / 8, from.y + step * (to.y - from.y) / 8},
          1);
  mouse("mouseReleased", to, 0);
  settle();
}

void Browser::settle() {
  // Moves of the mouse are handed to the page once a frame.
  evaluate(
      "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(1))))");
}

void Browser::press(const std::string& key) {
  for (const char* type : {"keyDown", "keyUp"})
    call("Input.dispatchKeyEvent", {{"type", type},
                                    {"key", key},
                                    {"code", key},
                                    {"windowsVirtualKeyCode", key == "ArrowLeft" ? 37 : 39}});
  settle();
}

void Browser::choose(const std::string& selector, const std::string& text) {
  // The list of a <select> is drawn by the system, where no page and no mouse of ours can reach.
  const Json found =
      evaluate("(() => { const node = document.querySelector(" + quoted(selector) +
               "); const i = [...node.options].findIndex((option) => option.textContent === " +
               quoted(text) +
               "); if (i < 0) return false; node.selectedIndex = i;"
               "node.dispatchEvent(new Event('change', {bubbles: true})); return true; })()");
  if (found != true) throw std::runtime_error(selector + " has no entry '" + text + "'");
}

std::filesystem::path Browser::downloaded(const std::string& name) {
  const std::filesystem::path file = folder_ / "downloads" / name;
  for (int tries = 0; tries < 600; ++tries) {
    if (std::filesystem::exists(file)) return file;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  throw std::runtime_error(name + " was not downloaded");
}

void Browser::screenshot(const std::filesystem::path& file) {
  const Json size = call("Page.getLayoutMetrics")["cssContentSize"];
  const Json clip{
      {"x", 0}, {"y", 0}, {"width", size["width"]}, {"height", size["height"]}, {"scale", 1}};
  const Json shot = call("Page.captureScreenshot",
                         {{"format", "png"}, {"captureBeyondViewport", true}, {"clip", clip}});
  const auto bytes = from_base64(shot["data"].get<std::string>());
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
}

const std::vector<std::string>& Browser::complaints() {
  // What the page said comes before the answer to this.
  evaluate("1");
  return complaints_;
}

}  // namespace stope::testing
