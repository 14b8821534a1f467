/** Panes that measure the cost of accuracy settings and effects, and scopes of the picture. */
@NullMarked
package lightning.editor.window.measure;

import org.jspecify.annotations.NullMarked;
