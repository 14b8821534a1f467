/** Light mixer with a strip for each light and light group of the scene. */
package lightning.editor.window.mixer;
