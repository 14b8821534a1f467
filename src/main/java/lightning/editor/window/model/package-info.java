/**
 * What the panes show and do, without a pane: the open document, its picture and how far it is, and what is remembered from one
 * run to the next.
 */
package lightning.editor.window.model;
