package lightning.editor.document.cue;

import java.nio.file.Path;
import java.util.Optional;
import lightning.render.image.Film;

/**
 * How a scene was lit, kept with a picture.
 *
 * @param name     that of its files, without their endings
 * @param file     its lights
 * @param lighting what the file says; empty where it cannot be read
 * @param problem  why it cannot: a sentence; empty where it can
 * @param picture  what was seen, as linear values of the display's codes; empty where there is no picture that can be read
 */
public record Cue(String name, Path file, Optional<Lighting> lighting, String problem, Optional<Film> picture) {}
