/** Panes that measure the cost of accuracy settings and effects, and scopes of the picture. */
package lightning.editor.window.measure;
