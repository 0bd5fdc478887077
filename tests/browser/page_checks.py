"""What must hold of every page, and of some."""

import html5lib
from pages import HOSTILE
from report import check, expect
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

PHONE = 360
DESKTOP = 1280

OVERFLOW = """
  const wide = document.documentElement.clientWidth;
  const out = Array.from(document.querySelectorAll("body *")).filter((element) =>
    !element.closest(".scroll, svg, .quiet, thead") && element.getBoundingClientRect().right > wide + 1);
  return [document.documentElement.scrollWidth - wide, out.slice(0, 3).map((e) => e.outerHTML.slice(0, 80))];
"""

NAMELESS = """
  const named = (element) => element.getAttribute("alt") || element.getAttribute("aria-label") ||
    (element.getAttribute("aria-labelledby") || "").split(" ").some((id) => id &&
      (document.getElementById(id) || {}).textContent);
  return Array.from(document.querySelectorAll("img, svg")).filter((element) => !named(element))
    .map((element) => element.outerHTML.slice(0, 80));
"""

# WCAG 2.1's contrast of every text that is seen with what is behind it.
CONTRAST = """
  const numbers = (color) => color.match(/[\\d.]+/g).map(Number);
  const light = (color) => {
    const [r, g, b] = numbers(color).map((v) => v / 255)
      .map((v) => v <= 0.03928 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const ground = (element) => {
    for (let e = element; e; e = e.parentElement) {
      const color = getComputedStyle(e).backgroundColor;
      const parts = numbers(color);
      if (parts.length < 4 || parts[3] > 0) return color;
    }
    return "rgb(255, 255, 255)";
  };
  const low = new Set();
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    const element = walker.currentNode.parentElement;
    if (!walker.currentNode.textContent.trim() || element.closest("script, title, desc, .quiet")) continue;
    const style = getComputedStyle(element);
    const color = element.closest("svg") ? style.fill : style.color;
    const [a, b] = [light(color), light(ground(element))].sort((x, y) => y - x);
    const ratio = (a + 0.05) / (b + 0.05);
    if (ratio < 4.5) low.add(`${element.tagName}.${element.className} ${ratio.toFixed(2)}`);
  }
  return Array.from(low);
"""

# Of what is no text: bars, points, badges' bars.
GRAPHICS = """
  const probe = document.createElement("span");
  document.body.append(probe);
  const light = (name) => {
    probe.style.color = `var(${name})`;
    const [r, g, b] = getComputedStyle(probe).color.match(/[\\d.]+/g).map((v) => v / 255)
      .map((v) => v <= 0.03928 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const low = [];
  for (const name of ["--drawn", "--asked", "--ok", "--failed", "--skipped"]) {
    const [a, b] = [light(name), light("--panel")].sort((x, y) => y - x);
    if ((a + 0.05) / (b + 0.05) < 3) low.push(name);
  }
  probe.remove();
  return low;
"""

SEEN = """return Array.from(document.querySelectorAll("#variant-table tbody tr"))
  .filter((row) => !row.hidden).map((row) => row.dataset.index)"""


def _empty(found, what):
    expect(not found, f"{what}: {found}")


def _is_valid(page):
    parser = html5lib.HTMLParser(strict=False)
    parser.parse(page.read_bytes(), transport_encoding="utf-8")
    _empty(parser.errors[:3], "not as HTML has it")


def _is_quiet(browser, page):
    _empty(browser.words(), "said on the console")
    others = [url for url in browser.requests() if url != page.as_uri() and not url.startswith("data:")]
    _empty(others, "asked for")


def _fits(browser):
    overflow, elements = browser.run(OVERFLOW)
    expect(overflow <= 0 and not elements, f"wider than the screen by {overflow}: {elements}")


def _pictures_load(browser):
    broken = browser.run("""
      const pictures = Array.from(document.images);
      pictures.forEach((image) => { image.loading = "eager"; });
      return Promise.all(pictures.map((image) => image.decode().then(() => null, () => image.alt)))
        .then((all) => all.filter(Boolean));""")
    _empty(broken, "cannot be decoded")


def _shows(browser, name):
    expected = {
        "one": "1 of 1 variant is shown.",
        "many": "40 of 300 variants are shown",
        "failing": "that failed or were skipped",
        "archive": "30 of 30 variants are shown.",
        "empty": "The manifest has no records",
        "gone": "have no picture",
        "interrupted": "still under construction",
        "tried": "Jaws lift and hold it",
    }[name]
    expect(expected in browser.run("return document.body.innerText"), f"no '{expected}'")


def _ids_are_unique(browser):
    _empty(browser.run("""
      const ids = Array.from(document.querySelectorAll("[id]")).map((element) => element.id);
      return ids.filter((id, i) => ids.indexOf(id) !== i);"""), "twice")


def run_basics(browser, pages, page, name):
    """Checks that hold of every page."""
    check(f"{name}: valid HTML", _is_valid, page)
    for scheme in ("light", "dark"):
        for width in (DESKTOP, PHONE):
            browser.open(page, width, scheme=scheme)
            at = f"{name}: {scheme}, {width} px"
            check(f"{at}: quiet, no requests", _is_quiet, browser, page)
            check(f"{at}: no overflow", _fits, browser)
            check(f"{at}: contrast of texts", lambda: _empty(browser.run(CONTRAST), "too low"))
            check(f"{at}: contrast of graphics", lambda: _empty(browser.run(GRAPHICS), "too low"))
            browser.take_picture(pages.folder / f"{name}-{scheme}-{width}.png", full=True)
    check(f"{name}: pictures load", _pictures_load, browser)
    check(f"{name}: pictures and charts have names",
          lambda: _empty(browser.run(NAMELESS), "nameless"))
    check(f"{name}: no id twice", _ids_are_unique, browser)


def run_all(browser, pages, name):
    run_basics(browser, pages, pages.page(name), name)
    check(f"{name}: shows what it should", _shows, browser, name)


def _sorts(browser):
    button = browser.driver.find_element(By.CSS_SELECTOR, "th[data-key=mass] button")
    masses = """return Array.from(document.querySelectorAll("#variant-table tbody tr"))
      .map((row) => Number(row.dataset.mass))"""
    before = browser.run(masses)
    expect(before != sorted(before), "sorted from the start: the check would see nothing")
    button.send_keys(Keys.ENTER)
    expect(browser.run(masses) == sorted(before), "not sorted upwards")
    header = button.find_element(By.XPATH, "..")
    expect(header.get_attribute("aria-sort") == "ascending", "aria-sort")
    button.send_keys(Keys.SPACE)
    expect(browser.run(masses) == sorted(before, reverse=True), "not sorted downwards")
    expect(header.get_attribute("aria-sort") == "descending", "aria-sort")
    other = browser.driver.find_element(By.CSS_SELECTOR, "th[data-key=index] button")
    other.send_keys(Keys.ENTER)
    indices = [int(index) for index in browser.run(SEEN)]
    expect(indices == sorted(indices), "not sorted by index")
    expect(header.get_attribute("aria-sort") == "none", "two are sorted by")


def _filters(browser, rows):
    text = browser.driver.find_element(By.ID, "filter-text")
    count = browser.driver.find_element(By.ID, "filter-count")
    text.send_keys("CYLinder")
    seen = len(browser.run(SEEN))
    expect(0 < seen < rows, f"{seen} of {rows} are seen")
    expect(count.text == f"{seen} of {rows}", count.text)
    text.clear()
    text.send_keys("no such words")
    expect(not browser.run(SEEN), "all are seen")
    text.clear()
    text.send_keys(" ")
    expect(len(browser.run(SEEN)) == rows, "not all come back")
    text.clear()


def _filters_by_list(browser, element, value, attribute):
    choice = browser.driver.find_element(By.ID, element)
    browser.run("arguments[0].value = arguments[1];"
                "arguments[0].dispatchEvent(new Event('input', {bubbles: true}))", choice, value)
    seen = browser.run(f"""return Array.from(document.querySelectorAll("#variant-table tbody tr"))
      .filter((row) => !row.hidden).map((row) => row.dataset.{attribute})""")
    expect(seen and all(value in words for words in seen), f"{seen}")
    rows = browser.run("return document.querySelectorAll('#variant-table tbody tr').length")
    expect(len(seen) < rows, "nothing is filtered")
    browser.run("arguments[0].value = '';"
                "arguments[0].dispatchEvent(new Event('input', {bubbles: true}))", choice)
    expect(len(browser.run(SEEN)) == rows, "not all come back")


def _is_reached_by_tab(browser):
    reached = set()
    browser.driver.find_element(By.TAG_NAME, "body").click()
    for _ in range(60):
        browser.driver.switch_to.active_element.send_keys(Keys.TAB)
        reached.add(browser.run("return document.activeElement.id || document.activeElement.textContent"))
    for wanted in ("filter-text", "filter-status", "filter-code", "Mass", "Size"):
        expect(wanted in reached, f"{wanted} is not reached")


def run_controls(browser, pages):
    browser.open(pages.page("many"))
    check("sorts by the keyboard", _sorts, browser)
    check("filters by text", _filters, browser, 40)
    check("all is reached by Tab", _is_reached_by_tab, browser)
    browser.open(pages.page("failing"))
    check("filters by status", _filters_by_list, browser, "filter-status", "ok", "status")
    check("filters by finding", _filters_by_list, browser, "filter-code", "model/bad-value", "codes")
    check("failed ones come first", lambda: expect(
        browser.run("return document.querySelector('#variant-table tbody tr').dataset.status")
        == "failed", "an other is first"))
    check("still quiet", _is_quiet, browser, pages.page("failing"))


def _is_only_words(browser):
    expect(browser.run("return document.querySelectorAll('[onerror], [onload]').length") == 0,
           "an element was made of a text")
    expect(browser.run("return document.scripts.length") == 1, "a script was made of a text")
    expect(browser.run("return document.querySelectorAll('img').length") == 0, "a picture")
    text = browser.run("return document.body.textContent")
    expect(text.count(HOSTILE) > 10, f"the words are there {text.count(HOSTILE)} times")
    expect("\x1b" not in text and "\u202e" not in text, "control characters")


def run_hostile(browser, pages):
    page = pages.page("hostile")
    check("hostile: valid HTML", _is_valid, page)
    browser.open(page, PHONE)
    check("hostile: only words", _is_only_words, browser)
    check("hostile: quiet, no requests", _is_quiet, browser, page)
    check("hostile: no overflow", _fits, browser)


def _is_readable(browser):
    text = browser.run("return document.body.textContent")
    for words in ("40 of 300 variants are shown", "mjforge replay many/manifest.jsonl:", "length",
                  "No variant has an error"):
        expect(words in text, f"no '{words}'")
    expect(browser.run("return getComputedStyle(document.getElementById('filter')).display")
           == "none", "a filter that does nothing is shown")
    expect(browser.run("return document.querySelectorAll('thead button').length") == 0,
           "buttons that do nothing are shown")
    expect(len(browser.run(SEEN)) == 40, "not all variants are there")


def run_without_script(browser, pages):
    page = pages.page("many")
    for width in (DESKTOP, PHONE):
        browser.open(page, width)
        check(f"without a script, {width} px: readable", _is_readable, browser)
        check(f"without a script, {width} px: no overflow", _fits, browser)
        check(f"without a script, {width} px: quiet", _is_quiet, browser, page)
        browser.take_picture(pages.folder / f"without-script-{width}.png")
