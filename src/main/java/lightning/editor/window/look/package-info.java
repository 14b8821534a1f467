/** Gallery of saved looks, which can be applied, compared and blended. */
@NullMarked
package lightning.editor.window.look;

import org.jspecify.annotations.NullMarked;
