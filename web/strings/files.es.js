/** Spanish: recent designs, files that are dropped, the page without the network. */
export const filesEs = {
  "files.drop": "Suelta un archivo de diseño para abrirlo",
  "edit.recent": "diseño reciente",
  "recent.title": "Diseños recientes",
  "recent.about": "Se guardan solo en este navegador, cada uno como quedó. Abrir uno se puede deshacer.",
  "recent.none": "Todavía no hay ninguno: aquí aparecerá lo que cambie o abra.",
  "recent.elsewhere": "abierto en otra pestaña",
  "recent.remove": "Quitar de la lista",
  "recent.remove.of": "Quitar «{title}» de la lista",
  "recent.removed": "Se quitó «{title}» de la lista.",
  "recent.clear": "Quitar todos",
  "recent.close": "Cerrar",
  "offline.ready": "Hay una versión nueva de LevaLab.",
  "offline.reload": "Recargar",
  "note.close": "Ahora no",
};
