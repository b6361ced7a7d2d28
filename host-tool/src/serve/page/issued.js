// Certificates that were issued: which are in force, and one in place of another.
import { row } from "./measurement.js";
import { certificate, load } from "./server.js";
import { say } from "./words.js";

const $ = (id) => document.getElementById(id);
let chosen = "";

/** One entry a certificate, with its forms, newest first. */
function by_number(issued) {
  const all = new Map();
  for (const file of issued) {
    const one = all.get(file.certificate) || { ...file, formats: [] };
    one.formats.push(file.format);
    all.set(file.certificate, one);
  }
  return [...all.values()].reverse();
}

function line(one) {
  const amend = document.createElement("button");
  amend.type = "button";
  amend.textContent = say("amend");
  amend.setAttribute("aria-label", say("amend {0}", one.certificate));
  amend.addEventListener("click", () => choose(one.certificate));
  const state = one.replaced_by ? say("replaced by {0}", one.replaced_by) : amend;
  const cells = row([one.certificate, new Date(1000 * one.issued_unix_time_s).toISOString().slice(0, 10), one.formats.join(" "), state],
    one.replaced_by ? "refused" : "", [say("certificate"), say("issued"), say("forms"), say("in force")]);
  for (const cell of cells.children) cell.className = "text";
  return cells;
}

/** Opens the form for what takes the place of this certificate. */
function choose(number) {
  chosen = number;
  show_amendment();
  $("reason").focus();
}

/** Links to what takes the place of the certificate chosen; they state what the form above states. */
export function show_amendment() {
  $("amendment").hidden = !chosen;
  $("amended").textContent = say("In place of certificate {0}", chosen);
  const reason = $("reason").value.trim();
  $("amendment-links").hidden = !reason;
  for (const link of document.querySelectorAll("#amendment a")) {
    link.href = certificate("api/amended/" + link.dataset.format, { replaces: chosen, reason });
  }
}

export async function show_issued() {
  const all = by_number((await load("api/certificates")) || []);
  $("issued-certificates").hidden = !all.length;
  $("issued-list").replaceChildren(...all.slice(0, 50).map(line));
  if (all.some((one) => one.certificate === chosen && one.replaced_by)) return;
  show_amendment();
}

$("reason").addEventListener("input", show_amendment);
