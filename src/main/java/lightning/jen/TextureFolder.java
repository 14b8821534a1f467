package lightning.jen;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import lightning.scene.Texture;
import lightning.text.Quote;

/**
 * Finds the textures of one scene: beside its file, in {@code textures/} there, or in
 * {@code textures/} of the nearest of the three folders above that has it. Each file is decoded once.
 */
final class TextureFolder {
    private static final int FOLDERS_ABOVE = 3;
    private static final Pattern PICTURE = Pattern.compile(".+\\.(png|jpe?g)", Pattern.CASE_INSENSITIVE);

    private final Path scene;
    private final Map<Path, Texture> decoded = new HashMap<>();
    private long pixels;

    /** @param scene the folder that holds the scene file */
    TextureFolder(Path scene) {
        this.scene = scene;
    }

    /** Says in a sentence why a texture cannot be used. */
    static final class UnusableException extends Exception {
        private static final long serialVersionUID = 1;

        UnusableException(String message) {
            super(message);
        }
    }

    /**
     * The decoded picture.
     *
     * @throws UnusableException if there is no such file inside the folders, if a link leads out of
     *     them, or if it is no PNG or JPEG within {@link JenLimits}
     */
    Texture load(String file) throws UnusableException {
        try {
            TextureName.check(file);
            Path path = find(file);
            Texture known = decoded.get(path);
            if (known != null) {
                return known;
            }
            if (decoded.size() == JenLimits.TEXTURES) {
                throw new UnusableException("a scene may have at most " + JenLimits.TEXTURES + " textures, found another, "
                        + Quote.of(file));
            }
            Texture texture = TextureDecoder.decode(file, path, JenLimits.ALL_TEXTURE_PIXELS - pixels);
            pixels += (long) texture.width() * texture.height();
            decoded.put(path, texture);
            return texture;
        } catch (IOException | InvalidPathException | SecurityException e) {
            throw new UnusableException("texture " + Quote.of(file) + " cannot be read: " + e.getMessage());
        } catch (IllegalArgumentException e) {
            throw new UnusableException(e.getMessage());
        }
    }

    /** The pictures that a scene there can name, by the end of their names, in alphabetical order; none of unreadable folders. */
    List<String> names() {
        var names = new TreeSet<String>(String.CASE_INSENSITIVE_ORDER);
        try {
            for (Path folder : folders()) {
                try (Stream<Path> files = Files.list(folder)) {
                    files.filter(Files::isRegularFile).map(f -> f.getFileName().toString())
                            .filter(f -> PICTURE.matcher(f).matches()).filter(TextureName::isAllowed).forEach(names::add);
                }
            }
        } catch (IOException | UncheckedIOException | SecurityException e) {
            return List.copyOf(names);
        }
        return List.copyOf(names);
    }

    private Path find(String file) throws UnusableException, IOException {
        List<Path> folders = folders();
        for (Path folder : folders) {
            Path path = folder.resolve(file);
            if (Files.isRegularFile(path)) {
                Path real = path.toRealPath();
                if (!real.startsWith(folder)) {
                    throw new UnusableException("texture " + Quote.of(file) + " must be inside " + shown(folder)
                            + ", found a link that leads out of it");
                }
                return real;
            }
        }
        throw new UnusableException("there is no texture " + Quote.of(file) + " in "
                + String.join(" or ", folders.stream().map(TextureFolder::shown).toList()));
    }

    /** Where textures may be, without links on the way; {@code textures} itself may be one, which then leads out. */
    private List<Path> folders() throws IOException {
        List<Path> folders = new ArrayList<>();
        Path above = scene.toRealPath();
        folders.add(above);
        for (int i = 0; i <= FOLDERS_ABOVE && above != null; i++, above = above.getParent()) {
            Path textures = above.resolve("textures");
            if (Files.isDirectory(textures)) {
                folders.add(textures);
                break;
            }
        }
        return folders;
    }

    private static String shown(Path folder) {
        return "the folder " + Quote.of((folder.getFileName() == null ? folder : folder.getFileName()).toString());
    }
}
