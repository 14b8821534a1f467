/** Tests that drive the editor like a user, on JavaFX's headless platform. */
package lightning.editor.window;
