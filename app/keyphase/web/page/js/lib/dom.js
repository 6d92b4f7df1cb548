/** Building elements without markup: every text goes in as text, so nothing in it can run. */

import { ICONS } from "./icons.js";

const SVG = "http://www.w3.org/2000/svg";

/**
 * @typedef {string|number|Node|null|undefined|false} Child
 */

/**
 * An HTML element. `class`, `text`, `title`, `data` (an object) and `on` (listeners) are set as
 * what they are, `style` as single properties (the content security policy forbids style
 * attributes), everything else as attributes.
 * @param {string} tag
 * @param {Object<string, *>} [attributes]
 * @param {...Child} children
 * @returns {HTMLElement}
 */
export function el(tag, attributes = {}, ...children) {
  return /** @type {HTMLElement} */ (build(document.createElement(tag), attributes, children));
}

/**
 * An SVG element, attributes and children as in `el`.
 * @param {string} tag
 * @param {Object<string, *>} [attributes]
 * @param {...Child} children
 * @returns {SVGElement}
 */
export function svg(tag, attributes = {}, ...children) {
  return /** @type {SVGElement} */ (
    build(document.createElementNS(SVG, tag), attributes, children)
  );
}

function build(node, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    if (name === "text") node.textContent = String(value);
    else if (name === "data") Object.assign(node.dataset, value);
    else if (name === "style") setStyle(node, value);
    else if (name === "on") listen(node, value);
    else node.setAttribute(name, value === true ? "" : String(value));
  }
  for (const child of children) {
    if (child === null || child === undefined || child === false) continue;
    node.append(child instanceof Node ? child : document.createTextNode(String(child)));
  }
  return node;
}

function setStyle(node, style) {
  for (const [property, value] of Object.entries(style)) node.style.setProperty(property, value);
}

function listen(node, listeners) {
  for (const [event, listener] of Object.entries(listeners)) node.addEventListener(event, listener);
}

/**
 * A 16 px line icon that takes the colour of its text.
 * @param {string} name one of icons.js
 * @param {string} [size] "small" for 12 px
 */
export function icon(name, size = "") {
  const shape = svg("svg", { class: `icon ${size}`, viewBox: "0 0 16 16", "aria-hidden": "true" });
  for (const [tag, attributes] of ICONS[name] ?? []) shape.append(svg(tag, attributes));
  return shape;
}

/** Puts the icon named by `data-icon` at the front of every element that names one. */
export function placeIcons(root = document) {
  for (const found of root.querySelectorAll("[data-icon]")) {
    const node = /** @type {HTMLElement} */ (found);
    node.prepend(icon(node.dataset.icon, node.dataset.iconSize ?? ""));
  }
}

/**
 * Draws the children anew and leaves the focus on the one with the same `data-NAME`, or on the one
 * `wanted`; where that has gone, on the last.
 * @param {HTMLElement} parent
 * @param {string} name
 * @param {Node[]} children
 * @param {string} [wanted]
 */
export function redraw(parent, name, children, wanted) {
  const focused = /** @type {HTMLElement} */ (document.activeElement);
  const held = parent.contains(focused) ? focused.dataset[name] : undefined;
  parent.replaceChildren(...children);
  if (held === undefined) return;
  const all = /** @type {HTMLElement[]} */ ([...parent.querySelectorAll(`[data-${name}]`)]);
  const next = all.find(({ dataset }) => dataset[name] === (wanted ?? held)) ?? all.at(-1);
  next?.focus({ preventScroll: true });
}

/**
 * The element with this id; the page is broken if it is not there.
 * @param {string} id
 * @returns {HTMLElement}
 */
export function byId(id) {
  const node = document.getElementById(id);
  if (!node) throw new Error(`index.html has no element #${id}`);
  return node;
}
