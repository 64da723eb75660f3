"use strict";
// Tabs for code in several languages; the choice is kept for all of them and for the next visit.
(function () {
  var KEY = "occgrid-language";
  var groups = Array.prototype.slice.call(document.querySelectorAll(".tabs"));

  function remembered() {
    try { return localStorage.getItem(KEY); } catch (error) { return null; }
  }
  function remember(language) {
    try { localStorage.setItem(KEY, language); } catch (error) { /* private windows */ }
  }
  function panelsOf(group) {
    return Array.prototype.slice.call(group.querySelectorAll(".panel"));
  }
  function show(language) {
    groups.forEach(function (group) {
      group.classList.toggle("all", language === "all");
      panelsOf(group).forEach(function (panel) {
        panel.hidden = language !== "all" && panel.dataset.language !== language;
      });
      group.querySelectorAll("[role=tab]").forEach(function (tab) {
        var chosen = tab.dataset.language === language;
        tab.setAttribute("aria-selected", String(chosen));
        tab.tabIndex = chosen ? 0 : -1;
      });
    });
  }

  groups.forEach(function (group, number) {
    var list = document.createElement("div");
    list.className = "tablist";
    list.setAttribute("role", "tablist");
    list.setAttribute("aria-label", "Language of the code");
    var choices = panelsOf(group).map(function (panel, i) {
      panel.id = "tabs-" + number + "-" + i;
      panel.setAttribute("role", "tabpanel");
      return [panel.dataset.language, panel.dataset.name, panel.id];
    });
    choices.push(["all", "all", choices.map(function (choice) { return choice[2]; }).join(" ")]);
    choices.forEach(function (choice) {
      var tab = document.createElement("button");
      tab.type = "button";
      tab.setAttribute("role", "tab");
      tab.setAttribute("aria-controls", choice[2]);
      tab.dataset.language = choice[0];
      tab.textContent = choice[1];
      tab.addEventListener("click", function () {
        var before = group.getBoundingClientRect().top;
        remember(choice[0]);
        show(choice[0]);
        window.scrollBy(0, group.getBoundingClientRect().top - before);
      });
      list.appendChild(tab);
    });
    list.addEventListener("keydown", function (event) {
      var step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
      if (!step) { return; }
      var tabs = Array.prototype.slice.call(list.children);
      var next = tabs[(tabs.indexOf(document.activeElement) + step + tabs.length) % tabs.length];
      next.focus();
      next.click();
    });
    group.insertBefore(list, group.firstChild);
  });
  if (groups.length > 0) {
    var known = panelsOf(groups[0]).map(function (panel) { return panel.dataset.language; }).concat("all");
    var wanted = remembered();
    show(known.indexOf(wanted) >= 0 ? wanted : document.body.dataset.language);
  }
})();
// What scrolls sideways can be reached, and scrolled, with the keyboard.
(function () {
  function mark() {
    document.querySelectorAll(".formula, .wide").forEach(function (box) {
      if (box.scrollWidth > box.clientWidth) {
        box.tabIndex = 0;
        box.setAttribute("role", "group");
        box.setAttribute("aria-label", box.classList.contains("wide") ? "Table" : "Equation");
      } else {
        box.removeAttribute("tabindex");
        box.removeAttribute("role");
        box.removeAttribute("aria-label");
      }
    });
  }
  addEventListener("load", mark);
  addEventListener("resize", mark);
})();
