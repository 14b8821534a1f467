/** Commands of the editor: their menus, buttons, shortcuts and dialogs. */
package lightning.editor.window.command;
