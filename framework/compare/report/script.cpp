#include "framework/compare/report/script.hpp"

namespace stope::report {

const char* comparison_script() {
  return R"js((function () {
  'use strict';
  const holder = document.getElementById('viewer-data');
  if (!holder) return;
  const data = JSON.parse(holder.textContent);
  const views = document.getElementById('views');
  const chosen = (id) => document.getElementById(id);
  const leftName = views.dataset.left;

  function make(tag, attributes, children) {
    const svg = ['svg', 'path', 'image', 'title'].includes(tag);
    const node = svg ? document.createElementNS('http://www.w3.org/2000/svg', tag)
                     : document.createElement(tag);
    for (const [name, value] of Object.entries(attributes || {})) node.setAttribute(name, value);
    for (const child of children || []) node.append(child);
    return node;
  }

  function pictureOf(file, alt) {
    if (!file) return null;
    const held = data.pictures[file.sum];
    return make('img', {alt: alt, draggable: 'false',
                        src: held ? 'data:image/png;base64,' + held : file.link});
  }

  function caption(name, texts) {
    const node = make('figcaption', {}, [make('b', {}, [name])]);
    for (const text of texts) node.append(' ', text);
    return node;
  }

  function absent(name, cells, arm) {
    const figure = make('figure', {class: 'view absent'});
    const why = [];
    if (!cells[0].files[name]) why.push(leftName + ': ' + (cells[0].why || 'no such file'));
    if (!cells[1].files[name]) why.push(arm + ': ' + (cells[1].why || 'no such file'));
    figure.append(make('p', {class: 'soft'}, [why.join('; ')]), caption(name, []));
    return figure;
  }

  // Two pictures, the right one cut off left of the slider's place.
  function slider(name, files, arm) {
    const frame = make('div', {class: 'slider'});
    const left = pictureOf(files[0], leftName), right = pictureOf(files[1], arm);
    right.className = 'over';
    const range = make('input', {type: 'range', min: '0', max: '100', step: '0.1', value: '50',
                                 'aria-label': 'how much of ' + leftName + ' is shown'});
    const place = () => frame.style.setProperty('--cut', range.value + '%');
    range.addEventListener('input', place);
    place();
    frame.append(left, right, make('span', {class: 'tab left'}, [leftName]),
                 make('span', {class: 'tab right'}, [arm]), make('i', {class: 'handle'}), range);
    return make('figure', {class: 'view'}, [frame, caption(name, [])]);
  }

  function same(name, file, arm) {
    const frame = make('div', {class: 'slider'}, [pictureOf(file, name)]);
    return make('figure', {class: 'view'},
                [frame, caption(name, ['the same bytes in ' + leftName + ' and ' + arm])]);
  }

  function key(style, text) {
    const path = make('path', {class: style, d: 'M1 5H21'});
    return make('span', {}, [make('svg', {class: 'key', viewBox: '0 0 22 10'}, [path]), text]);
  }

  function overlay(name, drawn, arm) {
    const svg = make('svg', {viewBox: '0 0 1000 ' + drawn.height, role: 'img',
                             'aria-label': name + ': ' + leftName + ' and ' + arm});
    if (drawn.map) {
      const {held, transform, ...place} = drawn.map;
      const image = make('image', {...place, preserveAspectRatio: 'none',
                                   href: 'data:image/png;base64,' + data.maps[held]});
      if (transform) image.setAttribute('transform', transform);
      svg.append(image);
    }
    const styles = ['common', 'only-left', 'only-right'];
    styles.forEach((style, i) => {
      if (drawn.parts[i]) svg.append(make('path', {class: style, d: drawn.parts[i]}));
    });
    const legend = make('span', {class: 'legend'}, [
      key('common', 'both ' + drawn.lengths[0]),
      key('only-left', 'only ' + leftName + ' ' + drawn.lengths[1]),
      key('only-right', 'only ' + arm + ' ' + drawn.lengths[2])]);
    const frame = make('div', {class: 'sheet'}, [svg]);
    return make('figure', {class: 'view map'},
                [frame, caption(name, ['one line if within ' + drawn.tolerance +
                                       (drawn.map ? '; the map is that of ' + leftName : '') + ' ',
                                       legend])]);
  }

  function show() {
    const run = chosen('recording').value + '/' + chosen('seed').value + '/';
    const select = chosen('arm');
    const arm = select.options[select.selectedIndex].textContent;
    const cells = [data.cells[run + data.baseline], data.cells[run + select.value]];
    const overlays = data.overlays[run + select.value] || {};
    views.replaceChildren();
    for (const output of data.outputs) {
      const files = cells.map((cell) => cell.files[output.name]);
      if (!files[0] || !files[1]) views.append(absent(output.name, cells, arm));
      else if (!output.picture && overlays[output.name])
        views.append(overlay(output.name, overlays[output.name], arm));
      else if (!output.picture) continue;
      else if (files[0].sum === files[1].sum) views.append(same(output.name, files[0], arm));
      else views.append(slider(output.name, files, arm));
    }
  }

  for (const id of ['recording', 'seed', 'arm']) chosen(id).addEventListener('change', show);
  show();
})();
)js";
}

}  // namespace stope::report
