/** Handles and picking in the preview: from a pointer to a place in the scene. */
package lightning.editor.document.manipulation;
