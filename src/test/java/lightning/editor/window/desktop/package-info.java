/** Tests the packaged program in a real window, on a virtual display. */
package lightning.editor.window.desktop;
