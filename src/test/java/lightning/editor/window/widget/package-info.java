/** Tests of the property editor's controls, each in a small window. */
package lightning.editor.window.widget;
