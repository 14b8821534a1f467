/** The controls of the property editor, each alone in a small window. */
package lightning.editor.window.widget;
