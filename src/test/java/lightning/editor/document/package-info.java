/** The editor without its window. */
package lightning.editor.document;
