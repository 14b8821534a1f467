/** Docks: places of the editor's window that show panels as tabs. */
package lightning.editor.window.dock;
