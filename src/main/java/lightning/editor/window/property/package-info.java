/** Panes for the scene's lights, shapes and materials: lists and property editors. */
@NullMarked
package lightning.editor.window.property;

import org.jspecify.annotations.NullMarked;
