/** Drives the editor as an artist does, on JavaFX's platform without a window system. */
package lightning.editor.window;
