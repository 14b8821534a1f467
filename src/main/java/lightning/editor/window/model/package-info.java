/** Model of the editor window without panes: document, picture and progress, display settings and preferences. */
package lightning.editor.window.model;
