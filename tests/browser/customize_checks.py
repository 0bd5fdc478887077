"""What must hold of the page of `mjforge customize`."""

import json

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
    _changes(page, control("stem_height", "input[inputmode=decimal]"), "0.39")
    _changes(page, control("stem_radius", "input[type=range]"), "0.01")
    _changes(page, control("base_half", ".row:nth-of-type(2) input[inputmode=decimal]"), "0.05")
    _changes(page, control("shade_color", "input[type=color]"), "#2050ff")
    _changes(page, control("feet", "input[inputmode=decimal]"), "3")
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
    slider, field = control("stem_height", "input[type=range]"), control("stem_height", "input[inputmode=decimal]")

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
    page.enter(control("stem_height", "input[inputmode=decimal]"), "0.2")
    page.wait()
    page.enter(control("stem_height", "input[inputmode=decimal]"), "0.4")
    page.wait()
    last = page.picture()
    page.click("#undo")
    page.wait()
    expect(page.value(control("stem_height", "input[inputmode=decimal]")) == "0.2", "not undone")
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


def _begins_with_view(page, served):
    """The view of the spec is the first one; the file's new view replaces it unless the page was turned."""
    def save(view):
        served.spec.write_text(SPEC + view, encoding="utf-8")
        until(lambda: page.picture() not in seen, f"{view or 'no view'}: the picture stays")
        page.wait()
        seen.append(page.picture())
    served.spec.write_text(SPEC, encoding="utf-8")
    until(lambda: page.value(control("stem_radius", "input[inputmode=decimal]")) == "0.006", "not read again")
    page.wait()
    seen = [page.picture()]
    expect(not page.run("return document.getElementById('view-pose').checkVisibility()"), "a pose without a view")
    save("view: {azimuth: 30deg, elevation: -70deg, pose: {tilt: -20deg}}\n")
    for button, position in ((None, -0.34907), ("#start-pose", 0.17453), ("#view-pose", -0.34907)):
        if button:
            page.click(button)
            page.wait()
        expect(abs(float(page.value("#j0")) - position) < 1e-4, f"{button}: {page.value('#j0')}")
    expect(page.picture() == seen[1], "not the pose of the view")
    page.browser.driver.find_element(By.ID, "view").send_keys(Keys.ARROW_LEFT)
    page.wait()
    seen.append(page.picture())
    expect(seen[2] != seen[1], "not turned")
    page.click("#front")
    page.wait()
    expect(page.picture() == seen[1], "not the first view")
    save("view: {azimuth: 30deg, elevation: -10deg}\n")
    served.spec.write_text(SPEC, encoding="utf-8")
    until(lambda: page.picture() == seen[0], "the view stays without `view:`")


def _reaches_all(page):
    """Joints and findings are in reach beside many parameters, with the picture in sight."""
    def is_inside(element):
        return page.run("""const [left, box] = [document.querySelector(".left"), document.querySelector(arguments[0])];
          left.scrollTop = left.scrollHeight;
          const { top, bottom } = box.getBoundingClientRect();
          return scrollY === 0 && top >= 0 && bottom <= innerHeight;""", element)
    for element in ("#joint-rows .control:last-child", "#findings", "#picture"):
        expect(is_inside(element), f"{element} is out of sight")


def _closes_film(page):
    """Escape closes a film, and it does not hide nine variants."""
    def is_shown():
        return page.run("return document.getElementById('film').checkVisibility()")
    for close in (lambda: page.browser.driver.switch_to.active_element.send_keys(Keys.ESCAPE),
                  lambda: page.enter("#nine", True)):
        page.click("#drop")
        until(is_shown, "no film")
        close()
        until(lambda: not is_shown(), "the film stays")
    page.enter("#nine", False)
    page.wait()


def _outdated_film(page):
    """A film that is made of an older state of the page does not appear."""
    made = "return performance.getEntriesByType('resource').filter((entry) => entry.name.includes('client=film')).length"
    before = page.run(made)
    page.click("#drop")
    page.enter(control("stem_height", "input[type=range]"), "0.25")
    until(lambda: page.run(made) > before, "no film is made")
    page.wait()
    expect(not page.run("return document.getElementById('film').checkVisibility()"), "the film of another variant")


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
    page.enter(control("stem_height", "input[inputmode=decimal]"), "0.3")
    page.wait()
    page.click("[data-export=command]")
    until(lambda: page.value("#copied") == "mjforge generate lamp.yaml --set stem_height=0.3",
          lambda: page.value("#copied"))
    page.click("[data-export=seed]")
    until(lambda: page.value("#copied") == "--seed 0 --index 0", lambda: page.value("#copied"))
    most = str(2**64 - 1)
    page.enter("#seed", most)
    page.wait()
    page.enter("#seed", str(2**64))
    expect(page.value("#seed") == most, "2^64 is taken for a seed")
    page.click("[data-export=seed]")
    until(lambda: page.value("#copied") == f"--seed {most} --index 0", lambda: page.value("#copied"))
    page.enter("#seed", "0")
    page.wait()
    page.enter("#preset-name", "mine")
    page.click("#preset-save")
    until(lambda: page.value("#copied").startswith("saved: "), lambda: page.value("#copied"))
    saved = (served.folder / "lamp.mine.params.yaml").read_text(encoding="utf-8")
    expect(saved.endswith("\nstem_height: 0.3\n"), saved)
    page.click("#reset")
    page.wait()
    page.enter("#preset", "mine")
    page.wait()
    expect(page.value(control("stem_height", "input[inputmode=decimal]")) == "0.3", "the preset sets nothing")


def _watches(page, served):
    page.enter(control("stem_height", "input[inputmode=decimal]"), "0.3")
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
    until(lambda: page.value(control("stem_radius", "input[inputmode=decimal]")) == "0.009", "not read again")
    page.wait()
    expect(page.picture() != before, "not drawn again")
    expect(page.value(control("stem_height", "input[inputmode=decimal]")) == "0.3", "a set value is lost")


def _shows_wrong_values(page):
    page.enter(control("stem_height", "input[inputmode=decimal]"), "-1")
    until(lambda: "error" in page.text("#findings"), "no finding")
    expect(not page.is_current(), "not outdated")
    page.enter(control("stem_height", "input[inputmode=decimal]"), "0.3")
    page.wait()
    expect(page.text("#findings") == "No findings.", page.text("#findings"))


def _two_tabs(browser, page, served):
    page.enter(control("stem_height", "input[inputmode=decimal]"), "0.2")
    page.wait()
    first = browser.driver.current_window_handle
    low = page.picture()
    browser.driver.switch_to.new_window("tab")
    browser.driver.get(served.address)
    page.wait()
    page.enter(control("stem_height", "input[inputmode=decimal]"), "0.4")
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
                ("a film of an older state", _outdated_film, (page,)),
                ("closing a film", _closes_film, (page,)),
                ("texts and presets", _takes_away, (page, served)),
                ("a wrong value", _shows_wrong_values, (page,)),
                ("two tabs", _two_tabs, (browser, page, served)),
                ("a file that is saved, with an error or without", _watches, (page, served)),
                ("the view of the spec", _begins_with_view, (page, served)),
                ("hostile texts are only words", _is_only_words, (page, served)),
        ):
            page.open(served)
            check(name, action, *arguments)
            _is_clean(browser, served)
    with Served(program, folder / "large", "washing_machine") as served:
        page.open(served)
        check("joints, findings and picture of a large spec", _reaches_all, page)
        _is_clean(browser, served)
    with Served(program, folder / "stopped") as served:
        page.open(served)
        check("a program that stops", _stops, page, served)
