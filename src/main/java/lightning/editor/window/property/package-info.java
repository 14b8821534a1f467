/**
 * The lights and materials of the scene: the list and what each is set to.
 */
package lightning.editor.window.property;
