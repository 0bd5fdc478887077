"""The gallery of `mjforge catalogue --html`: search, links, sliders, copied commands, labels."""

import page_checks
from report import check, expect
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

CHEST = """mjforge: 1
name: chest
description: Galleried chest with a lid.
params: {width: {value: 0.2 .. 0.4, unit: m, doc: Of the base.}, legs: {integer: [0, 4]}}
bodies:
  - {name: base, parts: [{name: block, type: box, size: [0.1, width / 2, 0.1]}]}
  - name: lid
    parent: base
    pos: [0, 0, 0.12]
    parts: [{name: board, type: box, size: [0.1, width / 2, 0.01]}]
    joints: [{name: hinge, type: hinge, axis: [0, -1, 0], pos: [-0.1, 0, 0], range: [0, 110deg]}]
"""
BALL = """mjforge: 1
name: ball
description: "Galleried <b onload=alert(1)>ball</b> with '\\" & marks"
parts: [{name: b, type: sphere, size: 0.1}]
"""
BROKEN = "mjforge: 1\nname: broken\nparst: []\nparts: [{name: b, type: sphere, size: 0.1}]\n"

SEEN = """return Array.from(document.querySelectorAll(".card"))
  .filter((card) => card.offsetParent !== null).map((card) => card.querySelector("h3").textContent)"""


def make(pages):
    for name, text in (("things/chest", CHEST), ("toys/a ball", BALL), ("galleried_broken", BROKEN)):
        file = pages.folder / "specs" / f"{name}.yaml"
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
    done = pages.run("catalogue", "galleried", "--html", "gallery", status=1,
                     environment={"MJFORGE_PATH": str(pages.folder / "specs")})
    expect("3 specs in gallery/index.html, 1 without a page" in done.stderr, done.stderr)
    return pages.folder / "gallery"


def _type(browser, words):
    field = browser.driver.find_element(By.ID, "filter-text")
    field.clear()
    field.send_keys(words, Keys.ENTER)
    return browser.run(SEEN)


def _searches(browser):
    expect(len(browser.run(SEEN)) == 3, "not all cards are shown")
    for words, wanted in (("LID", ["chest"]), ("legs base", ["chest"]), ("toys", ["a ball"]),
                          ("no such words", []), (" ", ["chest", "a ball", "galleried_broken"])):
        seen = _type(browser, words)
        expect(seen == wanted, f"'{words}' shows {seen}")
    _type(browser, "chest")
    kinds = browser.run("return Array.from(document.querySelectorAll('.kind'))"
                        ".filter((kind) => !kind.hidden).length")
    expect(kinds == 1, f"{kinds} kinds are shown")
    count = browser.driver.find_element(By.ID, "filter-count")
    expect(count.text == "1 of 3", count.text)
    expect(count.get_attribute("aria-live") == "polite", "the count is not announced")


def _says_what_is_broken(browser):
    card = browser.driver.find_element(By.XPATH, "//li[.//h3[text()='galleried_broken']]")
    expect("line 3: unknown key 'parst'" in card.text, card.text)
    expect(not card.find_elements(By.TAG_NAME, "a"), "it has a link")


def _links_lead(browser, folder):
    for name in ("chest", "a ball"):
        browser.open(folder / "index.html")
        browser.driver.find_element(By.LINK_TEXT, name).send_keys(Keys.ENTER)
        heading = browser.driver.find_element(By.TAG_NAME, "h1").text
        expect(heading.endswith(name), f"'{name}' leads to '{heading}'")
        browser.driver.find_element(By.LINK_TEXT, "mjforge catalogue").click()
        expect(browser.driver.find_element(By.TAG_NAME, "h1").text == "3 specs", "no way back")


def _moves(browser):
    shown = """return Array.from(document.querySelectorAll(".film li"))
      .filter((frame) => !frame.hidden).map((frame) => frame.querySelector("img").alt)"""
    slider = browser.driver.find_element(By.CSS_SELECTOR, ".film input[type=range]")
    label = browser.driver.find_element(By.CSS_SELECTOR, ".film label").text
    expect(label == "Position of hinge", label)
    expect(browser.run(shown) == ["things/chest with hinge at 110 deg"], f"{browser.run(shown)}")
    slider.send_keys(Keys.HOME)
    expect(browser.run(shown) == ["things/chest with hinge at 0 deg"], f"{browser.run(shown)}")
    expect(slider.get_attribute("aria-valuetext") == "0 deg", "no words for the position")


def _copies(browser):
    button = browser.driver.find_element(By.CSS_SELECTOR, ".commands button")
    expect(button.get_attribute("aria-label").startswith("Copy: mjforge generate things/chest"), "no label")
    button.send_keys(Keys.ENTER)
    expect(browser.run("return getSelection().toString()").startswith("mjforge generate things/chest"),
           "the command is not selected")


def _pages(folder):
    return (folder / "index.html", folder / "specs/things/chest.html", folder / "specs/toys/a ball.html")


def run_all(browser, pages):
    folder = make(pages)
    for page in _pages(folder):
        page_checks.run_basics(browser, pages, page, f"gallery-{page.stem}")
    browser.open(folder / "index.html")
    check("gallery: searches", _searches, browser)
    browser.open(folder / "index.html")
    check("gallery: says what is broken", _says_what_is_broken, browser)
    check("gallery: links lead to pages and back", _links_lead, browser, folder)
    browser.open(folder / "specs/things/chest.html")
    check("gallery: a slider moves a joint", _moves, browser)
    check("gallery: a command is copied", _copies, browser)


def _is_readable(browser):
    expect(browser.run("return getComputedStyle(document.getElementById('filter')).display") == "none",
           "a search that does nothing is shown")
    expect(len(browser.run(SEEN)) == 3, "not all cards are shown")


def run_without_script(browser, pages):
    folder = pages.folder / "gallery"
    browser.open(folder / "index.html")
    check("gallery without a script: all cards", _is_readable, browser)
    browser.open(folder / "specs/things/chest.html")
    check("gallery without a script: all frames", lambda: expect(
        browser.run("return document.querySelectorAll('.film li:not([hidden])').length") == 9, "not all"))
