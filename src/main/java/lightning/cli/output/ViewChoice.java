package lightning.cli.output;

import java.util.List;
import lightning.render.image.ViewTransform;

/**
 * Chosen view transform.
 *
 * @param notes sentences about its accuracy; empty for exact ones
 */
record ViewChoice(ViewTransform transform, List<String> notes) {
    ViewChoice {
        notes = List.copyOf(notes);
    }
}
