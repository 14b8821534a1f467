/**
 * What an artist can ask for: how commands look, the menus and buttons that carry them, and the questions that files raise.
 */
package lightning.editor.window.command;
