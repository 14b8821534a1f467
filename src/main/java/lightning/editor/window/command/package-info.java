/** Commands of the editor: their menus, buttons, shortcuts and dialogs. */
@NullMarked
package lightning.editor.window.command;

import org.jspecify.annotations.NullMarked;
