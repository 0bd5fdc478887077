"""What must hold of the page of `mjforge customize`."""

import json
import shlex
import subprocess

from page_checks import CONTRAST, DESKTOP, NAMELESS, OVERFLOW, PHONE
from pages import HOSTILE
from report import check, expect
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from served import SPEC, Served, Shown, control, until

UNLABELLED = """
  return Array.from(document.querySelectorAll("input, select, textarea, button")).filter((element) =>
    !element.hidden && !(element.labels && element.labels.length) && !element.getAttribute("aria-label") &&
    !element.textContent.trim()).map((element) => element.outerHTML.slice(0, 80));
"""


def _is_clean(browser, served):
    expect(not browser.words(), f"said on the console: {browser.words()}")
    others = [url for url in browser.requests()
              if not url.startswith((served.address, "data:", "blob:http://127.0.0.1"))]
    expect(not others, f"asked for {others}")


def _looks_good(browser, page, served, scheme, width):
    page.open(served, width=width, scheme=scheme)
    overflow, elements = browser.run(OVERFLOW)
    expect(overflow <= 0 and not elements, f"wider than the screen by {overflow}: {elements}")
    for script, what in ((CONTRAST, "contrast"), (NAMELESS, "names"), (UNLABELLED, "labels")):
        found = browser.run(script)
        expect(not found, f"{what}: {found}")
    _is_clean(browser, served)


def _changes(page, element, value, event="change"):
    before = page.picture()
    page.enter(element, value, event)
    page.wait()
    expect(page.picture() != before, f"{element}: the picture stays")


def _controls(page):
    _changes(page, "#index", "5")
    _changes(page, "#seed", "3")
    _changes(page, control("stem_height", "input[type=range]"), "0.22")
    _changes(page, control("stem_height", "input[type=number]"), "0.39")
    _changes(page, control("stem_radius", "input[type=range]"), "0.01")
    _changes(page, control("base_half", ".row:nth-of-type(2) input[type=number]"), "0.05")
    _changes(page, control("shade_color", "input[type=color]"), "#2050ff")
    _changes(page, control("feet", "input[type=number]"), "3")
    _changes(page, control("plug", "input[type=checkbox]"), False)
    shape = "1" if page.value(control("base_shape", "select")) == "0" else "0"
    _changes(page, control("base_shape", "select"), shape)
    page.enter(control("label", "input"), "reading")
    page.wait()
    page.click("[data-export=params]")
    until(lambda: "label: reading" in page.value("#copied"), lambda: page.value("#copied"))
    _changes(page, "#layer", "collision")
    _changes(page, "#layer", "visual")
    expect(page.text("#findings") == "No findings.", page.text("#findings"))


def _pairs_agree(page):
    """A slider and its number field, after every way of changing one of them."""
    slider, field = control("stem_height", "input[type=range]"), control("stem_height", "input[type=number]")

    def agree():
        expect(abs(float(page.value(slider)) - float(page.value(field))) < 1e-5,
               f"{page.value(slider)} and {page.value(field)}")
    for element, value in ((slider, "0.3"), (field, "0.25"), (field, "0.55"), (slider, "0.21")):
        page.enter(element, value)
        agree()
        page.wait()
        agree()
    for step in ("#undo", "#redo", "#dice", "#reset"):
        page.click(step)
        page.wait()
        agree()
    page.enter(field, "")
    agree()
    element = page.browser.driver.find_element(By.CSS_SELECTOR, field)
    element.send_keys(Keys.CONTROL, "a")
    element.send_keys("0.33", Keys.ENTER)
    page.wait()
    agree()
    expect(page.value(slider) == "0.33", page.value(slider))


def _history(page):
    first = page.picture()
    page.enter(control("stem_height", "input[type=number]"), "0.2")
    page.wait()
    page.enter(control("stem_height", "input[type=number]"), "0.4")
    page.wait()
    last = page.picture()
    page.click("#undo")
    page.wait()
    expect(page.value(control("stem_height", "input[type=number]")) == "0.2", "not undone")
    page.click("#redo")
    page.wait()
    expect(page.picture() == last, "not redone")
    page.click("#reset")
    page.wait()
    expect(page.picture() == first, "not reset")
    page.click(control("stem_height", "button:first-of-type"))
    until(lambda: page.run("return document.querySelector('[data-name=stem_height]').classList.contains('set')"),
          "the die sets nothing")
    page.wait()
    page.click(control("stem_height", "button:last-of-type"))
    page.wait()
    expect(page.picture() == first, "not as in the spec")


def _view(page):
    driver = page.browser.driver
    figure = driver.find_element(By.ID, "view")
    seen = [page.picture()]

    def has_new(what):
        page.wait()
        expect(page.picture() not in seen, f"{what}: the picture stays")
        seen.append(page.picture())
    ActionChains(driver).click_and_hold(figure).move_by_offset(80, 20).release().perform()
    has_new("dragging")
    page.run("document.getElementById('view').dispatchEvent(new WheelEvent('wheel', {deltaY: -300, cancelable: true}))")
    has_new("wheel")
    figure.send_keys(Keys.ARROW_LEFT)
    has_new("arrow")
    figure.send_keys("0")
    page.wait()
    expect(page.picture() == seen[0], "not the first view")
    ActionChains(driver).move_to_element_with_offset(figure, 0, -int(figure.rect["height"] / 3)).double_click().perform()
    until(lambda: page.text("#part").startswith("lamp_shade, "), lambda: page.text("#part"))
    page.wait()
    _changes(page, "#j0", "0.5")
    page.enter("#j0", "0")
    page.wait()
    _changes(page, "#nine", True)
    box = figure.rect
    ActionChains(driver).move_to_element_with_offset(figure, box["width"] / 3, box["height"] / 3).click().perform()
    page.wait()
    expect(page.value("#index") == "8", f"chose {page.value('#index')}")


def _poses(page):
    start = page.picture()
    _changes(page, "#j0", "0.5")
    page.click("#zero-pose")
    page.wait()
    expect(page.value("#j0") == "0", f"not at zero: {page.value('#j0')}")
    expect(page.picture() != start, "zero looks like the start")
    page.click("#start-pose")
    page.wait()
    expect(abs(float(page.value("#j0")) - 0.17453) < 1e-4, f"not at the start: {page.value('#j0')}")
    expect(page.picture() == start, "not the picture of the start")


def _films(page):
    """The films of the drop and of a joint are animations, and end with another variant."""
    def is_shown():
        return page.run("return !document.getElementById('film').hidden && "
                        "document.getElementById('film-picture').complete")
    for button, words in (("#drop", "Drop, "), ("#joint-rows button", "Drive of lamp_tilt, ")):
        page.click(button)
        until(lambda w=words: is_shown() and page.text("#film-text").startswith(w), lambda: page.text("#film-text"))
        width, height = page.run("const film = document.getElementById('film-picture');"
                                 "return [film.naturalWidth, film.naturalHeight]")
        expect((width, height) == (360, 270), f"{width} x {height}")
    page.click("#film-close")
    expect(not is_shown(), "not closed")
    page.click("#drop")
    until(is_shown, "no film")
    _changes(page, control("stem_height", "input[type=range]"), "0.22")
    expect(not is_shown(), "the film of another variant stays")


def _takes_away(page, served):
    page.enter(control("stem_height", "input[type=number]"), "0.3")
    page.wait()
    page.click("[data-export=command]")
    until(lambda: page.value("#copied") == "mjforge generate lamp.yaml --set stem_height=0.3",
          lambda: page.value("#copied"))
    page.click("[data-export=seed]")
    until(lambda: page.value("#copied") == "--seed 0 --index 0", lambda: page.value("#copied"))
    page.enter("#preset-name", "mine")
    page.click("#preset-save")
    until(lambda: page.value("#copied").startswith("saved: "), lambda: page.value("#copied"))
    saved = (served.folder / "lamp.mine.params.yaml").read_text(encoding="utf-8")
    expect(saved.endswith("\nstem_height: 0.3\n"), saved)
    page.click("#reset")
    page.wait()
    page.enter("#preset", "mine")
    page.wait()
    expect(page.value(control("stem_height", "input[type=number]")) == "0.3", "the preset sets nothing")


def _watches(page, served):
    page.enter(control("stem_height", "input[type=number]"), "0.3")
    page.wait()
    before = page.picture()
    served.spec.write_text(SPEC.replace("type: sphere", "type: spher"), encoding="utf-8")
    until(lambda: "'spher' is not one of" in page.text("#findings"), "no error")
    expect(not page.is_current(), "the picture is not marked as outdated")
    expect(page.picture() == before, "the last picture is gone")
    place = page.run("return document.querySelector('#findings button').textContent")
    line = SPEC[:SPEC.index("type: sphere")].count("\n") + 1
    expect(place == f"lamp.yaml:{line}", place)
    page.click("#findings button")
    until(lambda: "spher" in page.run("return (document.querySelector('#source .here') || {}).textContent || ''"),
          "the line is not shown")
    served.spec.write_text(SPEC.replace("[0.9, 0.3, 0.2, 1]", "[0.1, 0.8, 0.2, 1]")
                           .replace("6mm", "9mm"), encoding="utf-8")
    until(lambda: page.value(control("stem_radius", "input[type=number]")) == "0.009", "not read again")
    page.wait()
    expect(page.picture() != before, "not drawn again")
    expect(page.value(control("stem_height", "input[type=number]")) == "0.3", "a set value is lost")


def _shows_wrong_values(page):
    page.enter(control("stem_height", "input[type=number]"), "-1")
    until(lambda: "error" in page.text("#findings"), "no finding")
    expect(not page.is_current(), "not outdated")
    page.enter(control("stem_height", "input[type=number]"), "0.3")
    page.wait()
    expect(page.text("#findings") == "No findings.", page.text("#findings"))


def _two_tabs(browser, page, served):
    page.enter(control("stem_height", "input[type=number]"), "0.2")
    page.wait()
    first = browser.driver.current_window_handle
    low = page.picture()
    browser.driver.switch_to.new_window("tab")
    browser.driver.get(served.address)
    page.wait()
    page.enter(control("stem_height", "input[type=number]"), "0.4")
    page.wait()
    expect(page.picture() != low, "both tabs have one state")
    browser.driver.close()
    browser.driver.switch_to.window(first)
    page.click("#front")
    page.wait()
    expect(page.picture() == low, "the other tab changed this one")


def _stops(page, served):
    before = page.picture()
    expect(served.stop() == 0, "the exit status is not 0")
    until(lambda: page.run("return !document.getElementById('stopped').hidden"), "it is not noticed")
    expect(page.picture() == before, "the last picture is gone")


def _is_only_words(page, served):
    quoted = json.dumps(HOSTILE)
    served.spec.write_text(SPEC.replace("Height of the stem.", quoted).replace("description: Desk", f"description: {quoted} #"), encoding="utf-8")
    until(lambda: HOSTILE in page.run("return document.body.textContent"), "the words do not come")
    page.wait()
    expect(page.run("return document.querySelectorAll('[onerror], [onload], svg').length") == 0, "an element")
    expect(page.run("return document.scripts.length") == 1, "a script")


TALL = """mjforge: 1
name: tall
params:
  height: {value: 10cm .. 60cm, unit: m}
parts:
  - {name: foot, type: cylinder, size: [4cm, 5mm], pos: [0, 0, 5mm], density: 2000}
  - {name: stem, type: cylinder, size: [5mm, height / 2], pos: [0, 0, height / 2], density: 2000}
  - {name: shade, type: cylinder, size: [6cm, 3cm], pos: [0, 0, height], density: 300}
checks: {stable: true}
"""


def _tallest(page):
    """A user finds the tallest lamp that does not tip over."""
    slider = control("height", "input[type=range]")
    page.enter("#simulate", True)
    low, high = 0.1, 0.6
    for _ in range(6):
        middle = (low + high) / 2
        page.enter(slider, str(middle))
        page.wait()
        low, high = (low, middle) if "topples" in page.text("#findings") else (middle, high)
    expect(0.3 <= low and high <= 0.5, f"{low} to {high}")
    return f"{low:.2f} m"


def _ten_mugs(page, program, served):
    """A user makes ten mugs in a colour that the spec does not have."""
    page.enter(control("glaze", "input[type=color]"), "#00aaff")
    page.wait()
    page.enter("#count", "10")
    page.click("[data-export=command]")
    until(lambda: page.value("#copied").startswith("mjforge generate mug"), lambda: page.value("#copied"))
    words = shlex.split(page.value("#copied"))
    subprocess.run([program, *words[1:], "-q"], cwd=served.folder, check=True)
    mugs = sorted((served.folder / "mug").glob("*.xml"))
    expect(len(mugs) == 10, f"{len(mugs)} mugs")
    for mug in mugs:
        expect("0 0.66667 1 1" in mug.read_text(encoding="utf-8"), f"{mug.name} has another colour")


def _culprit(page):
    """A user finds the parameter that makes drawers collide."""
    page.enter("#simulate", True)
    guilty = []
    for name, value in (("width", "0.4"), ("plinth", "0.05"), ("gap", "-0.002"), ("drawer_board", "0.01")):
        page.enter(control(name, "input[type=number]"), value)
        page.wait()
        if "'cabinet' and 'cabinet_drawer_0' touch" in page.text("#findings"):
            guilty.append(name)
        page.click("#undo")
        page.wait()
    expect(guilty == ["gap"], guilty)


def run_tasks(browser, program, folder):
    page = Shown(browser)
    (folder / "tasks").mkdir()
    (folder / "tasks/tall.yaml").write_text(TALL, encoding="utf-8")
    for spec, name, action in (("tall.yaml", "the tallest lamp that does not tip over", lambda served: _tallest(page)),
                               ("mug", "ten mugs in a colour", lambda served: _ten_mugs(page, program, served)),
                               ("drawer_cabinet", "what makes drawers collide", lambda served: _culprit(page))):
        with Served(program, folder / "tasks", spec) as served:
            page.open(served)
            check(name, action, served)


def run_all(browser, program, folder):
    page = Shown(browser)
    with Served(program, folder / "served") as served:
        for scheme in ("light", "dark"):
            for width in (DESKTOP, PHONE):
                check(f"{scheme}, {width} px: contrast, names, labels, no overflow", _looks_good, browser, page,
                      served, scheme, width)
                browser.take_picture(folder / f"customize-{scheme}-{width}.png")
        for name, action, arguments in (
                ("every control changes the picture", _controls, (page,)),
                ("sliders and number fields agree", _pairs_agree, (page,)),
                ("undo, redo, reset, dice", _history, (page,)),
                ("the view, joints and nine variants", _view, (page,)),
                ("the start pose, and joints at zero", _poses, (page,)),
                ("films", _films, (page,)),
                ("texts and presets", _takes_away, (page, served)),
                ("a wrong value", _shows_wrong_values, (page,)),
                ("two tabs", _two_tabs, (browser, page, served)),
                ("a file that is saved, with an error or without", _watches, (page, served)),
                ("hostile texts are only words", _is_only_words, (page, served)),
        ):
            page.open(served)
            check(name, action, *arguments)
            _is_clean(browser, served)
    with Served(program, folder / "stopped") as served:
        page.open(served)
        check("a program that stops", _stops, page, served)
