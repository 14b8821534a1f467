/** Docks: places of the editor's window that show panels as tabs. */
@NullMarked
package lightning.editor.window.dock;

import org.jspecify.annotations.NullMarked;
