package lightning.app;

import java.io.IOException;
import java.io.Reader;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Properties;
import lightning.file.SafeFile;

/** What the editor remembers from one run to the next. A file that is missing or damaged counts as empty. */
final class Preferences {
    private static final int RECENT = 10;

    private final Path file;
    private final Properties values = new Properties();

    /** Reads them from a folder. */
    Preferences(Path folder) {
        file = folder.resolve("preferences.properties");
        if (Files.isRegularFile(file)) {
            try (Reader in = Files.newBufferedReader(file)) {
                values.load(in);
            } catch (IOException | IllegalArgumentException e) {
                values.clear();
            }
        }
    }

    String text(String key, String otherwise) {
        return values.getProperty(key, otherwise);
    }

    double number(String key, double otherwise) {
        try {
            return Double.parseDouble(text(key, ""));
        } catch (NumberFormatException e) {
            return otherwise;
        }
    }

    void set(String key, Object value) {
        values.setProperty(key, value.toString());
    }

    /** The scenes opened last, the latest first. */
    List<Path> recent() {
        List<Path> files = new ArrayList<>();
        for (int i = 0; i < RECENT; i++) {
            String path = text("recent." + i, "");
            try {
                if (!path.isEmpty()) {
                    files.add(Path.of(path));
                }
            } catch (InvalidPathException e) {
                // Another system wrote it.
            }
        }
        return files;
    }

    /** A scene was opened or saved. */
    void opened(Path scene) {
        List<Path> files = new ArrayList<>(recent());
        Path whole = scene.toAbsolutePath().normalize();
        files.remove(whole);
        files.addFirst(whole);
        for (int i = 0; i < Math.min(RECENT, files.size()); i++) {
            set("recent." + i, files.get(i));
        }
        save();
    }

    /** Writes them. Preferences that cannot be kept are no reason to disturb anybody. */
    void save() {
        try {
            Files.createDirectories(file.toAbsolutePath().getParent());
            SafeFile.write(file, out -> values.store(out, "Lightning"));
        } catch (IOException e) {
            // The next run starts without them.
        }
    }
}
