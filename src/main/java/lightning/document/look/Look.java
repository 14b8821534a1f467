package lightning.document.look;

import java.nio.file.Path;
import java.util.Optional;
import lightning.render.image.Film;

/**
 * Saved look of a scene: its lighting with a thumbnail.
 *
 * @param name     name of its files, without extension
 * @param file     file with its lights
 * @param lighting content of the file; empty if it cannot be read
 * @param problem  reason why it cannot be read, a sentence; empty if it can
 * @param picture  saved image, as linear values of the display codes; empty if there is no readable image
 */
public record Look(String name, Path file, Optional<Lighting> lighting, String problem, Optional<Film> picture) {}
