/** Panes for the scene's lights, shapes and materials: lists and property editors. */
package lightning.editor.window.property;
