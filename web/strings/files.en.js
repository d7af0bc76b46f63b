/** English: recent designs, files that are dropped, the page without the network. */
export const filesEn = {
  "files.drop": "Drop a design file to open it",
  "edit.recent": "recent design",
  "recent.title": "Recent designs",
  "recent.about": "Kept in this browser alone, each as it was last. Opening one can be undone.",
  "recent.none": "None yet: what you change or open will be listed here.",
  "recent.elsewhere": "open in another tab",
  "recent.remove": "Remove from the list",
  "recent.remove.of": "Remove “{title}” from the list",
  "recent.removed": "“{title}” was removed from the list.",
  "recent.clear": "Remove all",
  "recent.close": "Close",
  "offline.ready": "A new version of LevaLab is ready.",
  "offline.reload": "Reload",
  "note.close": "Not now",
};
