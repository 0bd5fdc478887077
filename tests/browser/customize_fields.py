"""Fields and findings of the page of `mjforge customize`: what a user types, and where mistakes are shown."""

import shlex
import subprocess

from report import check, expect
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from served import Served, Shown, control, until

FIELDS = """mjforge: 1
name: fields
params:
  height: {value: 20cm .. 40cm, unit: m}
  big: {value: 100000.1 .. 100000.9}
  half: {value: [8cm, 8cm, 2cm], unit: m}
  label: hello
bodies:
  - name: base
    parts:
      - {name: plate, if: label != '', type: box, size: half, density: 500}
      - {name: weight, type: box, size: [1cm, 1cm, big * 1e-6], pos: [0, 0, 10cm], density: 500}
  - name: arm
    parent: base
    pos: [0, 0, height]
    parts: [{name: rod, type: capsule, size: [1cm, 5cm], density: 500}]
    joints: [{name: turn, axis: [0, 1, 0], range: [-90deg, 90deg]}]
"""
NUMBER = "input[inputmode=decimal]"
TEXTS = ("12", "a + b", "it's", "x: y", "[1, 2]", "#", "~", "hello", "max", "${label}", " a")


def _shows(page, element, value):
    until(lambda: page.value(element) == value, lambda: f"{page.value(element)}, not {value}")


def _keeps_texts(page, program, served):
    """A text field takes every text, and so does the copied command."""
    field = control("label", "input")
    for text in TEXTS:
        page.enter(field, text)
        page.wait()
        expect(page.text("#findings") == "No findings.", f"{text}: {page.text('#findings')}")
        _shows(page, field, text)
    page.click("[data-export=command]")
    until(lambda: "' a'" in page.value("#copied"), lambda: page.value("#copied"))
    words = shlex.split(page.value("#copied"))
    subprocess.run([program, *words[1:], "-q", "-o", "a.xml"], cwd=served.folder, check=True)


def _takes_units(page):
    for element, typed, value in ((control("height", NUMBER), "25cm", "0.25"), (control("height", NUMBER), "2 * 15cm", "0.3"),
                                  (control("half", ".row:nth-of-type(3) " + NUMBER), "15mm", "0.015")):
        page.enter(element, typed)
        page.wait()
        _shows(page, element, value)
    page.enter("#j0", "30deg")
    page.wait()
    expect(abs(float(page.value("#j0")) - 0.5236) < 1e-4, page.value("#j0"))
    page.enter("#j0", "much")
    until(lambda: "'much' is not a position of fields_turn" in page.text("#findings"), lambda: page.text("#findings"))
    page.enter("#j0", "0")
    page.wait()
    for name, element, typed in (("height", NUMBER, "0,25"), ("half", ".row:nth-of-type(2) " + NUMBER, "0,08")):
        page.enter(control(name, element), typed)
        until(lambda: "',' only separates" in page.text("#findings"), lambda: page.text("#findings"))
        expect(page.value(control(name, element)) == typed, f"{typed} became {page.value(control(name, element))}")
        expect(typed in page.text(control(name, ".fault")), f"no finding at {name}")
        page.click("#undo")
        page.wait()
    expect(page.text(control("height", ".fault")) == "", "the finding stays")


def _types_freely(page):
    """What is typed is not replaced while it is typed."""
    field = page.browser.driver.find_element(By.CSS_SELECTOR, control("height", NUMBER))
    field.send_keys(Keys.CONTROL, "a")
    for part in ("2", "5", "c", "m"):
        field.send_keys(part)
        until(lambda: page.run("return document.getElementById('state').textContent !== 'drawing ...'"), "no answer")
    page.wait()
    expect(page.value(control("height", NUMBER)) == "25cm", page.value(control("height", NUMBER)))
    field.send_keys(Keys.ENTER, Keys.TAB)
    page.wait()
    _shows(page, control("height", NUMBER), "0.25")


def _rounds_within_range(page):
    slider, field = control("big", "input[type=range]"), control("big", NUMBER)
    for value in ("100000.1", "100000.34567", "100000.9"):
        page.enter(slider, value)
        page.wait()
        expect(page.text("#findings") == "No findings.", page.text("#findings"))
        expect(100000.1 <= float(page.value(field)) <= 100000.9, page.value(field))
        expect(abs(float(page.value(field)) - float(value)) < 1e-3, page.value(field))


def _counts_findings(page, served):
    """The number of findings is in sight, and leads to them."""
    expect(not page.run("return document.getElementById('count-findings').checkVisibility()"), "a count of nothing")
    served.spec.write_text(FIELDS.replace("size: half", "size: half, sise: 1"), encoding="utf-8")
    until(lambda: page.text("#count-findings") == "1 error", lambda: page.text("#count-findings"))
    served.spec.write_text(FIELDS.replace("  label", "  unused: 1\n  label"), encoding="utf-8")
    until(lambda: page.text("#count-findings") == "1 warning", lambda: page.text("#count-findings"))
    page.click("#count-findings")
    until(lambda: _is_in_sight(page, "#findings li"), "the findings are out of sight")


def _is_in_sight(page, element):
    return page.run("""const element = document.querySelector(arguments[0]);
      const { left, top, height } = element.getBoundingClientRect();
      return element.contains(document.elementFromPoint(left + 3, top + height / 2));""", element)


def _shows_line(page):
    figure = page.browser.driver.find_element(By.ID, "view")
    ActionChains(page.browser.driver).move_to_element(figure).double_click().perform()
    until(lambda: page.text("#part").endswith(" lamp.yaml:" + page.text("#part").split(":")[-1]),
          lambda: page.text("#part"))
    until(lambda: page.run("return Boolean(document.querySelector('#source .here'))"), "no line")
    until(lambda: _is_in_sight(page, "#source .here"), "the line is out of sight")


def _forgets_values(page, served):
    """The value of a parameter that the file no longer has is not used, also after Undo."""
    field = control("height", NUMBER)
    page.enter(field, "0.3")
    page.wait()
    page.enter(field, "0.35")
    page.wait()
    served.spec.write_text(FIELDS.replace("  height: {value: 20cm .. 40cm, unit: m}\n", "")
                           .replace("0, height]", "0, 0.3]"), encoding="utf-8")
    until(lambda: not page.run("return document.querySelector(arguments[0])", field), "the control stays")
    for step in (None, "#undo", "#redo"):
        if step:
            page.click(step)
        page.wait()
        expect(page.text("#findings") == "No findings.", page.text("#findings"))


def _shows_wrong_type(page, served):
    page.enter(control("height", NUMBER), "0.3")
    page.wait()
    served.spec.write_text(FIELDS.replace("height: {value: 20cm .. 40cm, unit: m}", "height: {value: [1, 2], unit: m}")
                           .replace("0, height]", "0, height.x]"), encoding="utf-8")
    until(lambda: "0.3: parameter 'height' is 2 numbers, but '0.3' is a number" in page.text(control("height", ".fault")),
          lambda: page.text("#findings"))
    page.click(control("height", "button:last-of-type"))
    page.wait()
    expect(page.text(control("height", ".fault")) == "", "the finding stays")


def _names_failures(page, served):
    served.spec.write_text(FIELDS.replace("size: half", "size: [25mm - index * 1cm, half.x, half.y]"), encoding="utf-8")
    page.enter("#nine", True)

    def texts():
        return page.run("return Array.from(document.querySelectorAll('#cells span')).map((e) => e.textContent)")
    until(lambda: [text.split(":")[0] for text in texts()] == ["", "", "", *(f"index {i} failed" for i in range(3, 9))], texts)
    page.enter("#nine", False)
    until(lambda: not texts(), "the texts stay")


def run_all(browser, program, folder):
    page = Shown(browser)
    with Served(program, folder / "fields") as served:
        for name, action, arguments in (
                ("a text field takes every text", _keeps_texts, (page, program, served)),
                ("numbers with units, and numbers that are none", _takes_units, (page,)),
                ("a number that is being typed", _types_freely, (page,)),
                ("a narrow range far from zero", _rounds_within_range, (page,)),
                ("the number of findings", _counts_findings, (page, served)),
                ("the line of a part", _shows_line, (page,)),
                ("values of a parameter that is gone", _forgets_values, (page, served)),
                ("a value of another type", _shows_wrong_type, (page, served)),
                ("variants that fail among nine", _names_failures, (page, served)),
        ):
            served.spec.write_text(FIELDS, encoding="utf-8")
            page.open(served)
            until(lambda: page.run("return document.querySelector(arguments[0])", control("height", NUMBER)) and
                  page.text("#findings") == "No findings.", lambda: page.text("#findings"))
            check(name, action, *arguments)
