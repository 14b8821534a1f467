/** Gallery of saved looks (looks), which can be applied, compared and blended. */
@NullMarked
package lightning.editor.window.look;

import org.jspecify.annotations.NullMarked;
