package lightning.editor.window.model;

import java.io.IOException;
import java.io.InputStream;
import java.io.StringReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Properties;
import java.util.concurrent.Executor;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import lightning.base.file.AtomicFile;
import lightning.base.file.ParentFolder;
import lightning.base.file.PrivateFolder;

/**
 * Editor settings stored between sessions.
 *
 * <p>An invalid or out-of-range value counts as absent, and so does every value of an unreadable file. Other values are kept.
 */
public final class Preferences {
    private static final int MAX_RECENT = 10;
    private static final int MAX_BYTES = 1 << 20;
    /** Unicode escape without its four digits, which makes {@link Properties#load} throw. */
    private static final Pattern INVALID_ESCAPE = Pattern.compile("(?<!\\\\)(?:\\\\\\\\)*+\\\\u(?![0-9a-fA-F]{4})");

    private final Path file;
    private final Executor writeExecutor;
    private final Properties values = new Properties();

    /**
     * Reads the preferences of a folder.
     *
     * @param writeExecutor  runs file writes in order
     */
    public Preferences(Path folder, Executor writeExecutor) {
        this.writeExecutor = writeExecutor;
        file = folder.resolve("preferences.properties");
        if (Files.isRegularFile(file)) {
            try (InputStream in = Files.newInputStream(file)) {
                String text = new String(in.readNBytes(MAX_BYTES), StandardCharsets.UTF_8);
                // One call for all lines: each call allocates 18 kB.
                values.load(new StringReader(
                        text.lines().filter(line -> !INVALID_ESCAPE.matcher(line).find()).map(Preferences::withoutContinuation)
                                .collect(Collectors.joining("\n"))));
            } catch (IOException e) {
                values.clear();
            }
        }
    }

    /** Removes a trailing line continuation. Each value has one line, so that an invalid line does not affect others. */
    private static String withoutContinuation(String line) {
        int end = line.length();
        while (end > 0 && line.charAt(end - 1) == '\\') {
            end--;
        }
        return (line.length() - end) % 2 == 0 ? line : line.substring(0, line.length() - 1);
    }

    private String text(String key) {
        return text(key, "");
    }

    /** Returns a text, or {@code defaultValue} if absent. */
    public String text(String key, String defaultValue) {
        return values.getProperty(key, defaultValue);
    }

    /** Returns whether a key has the given value. */
    public boolean hasValue(String key, String value) {
        return text(key).equals(value);
    }

    /** Returns a number between {@code min} and {@code max}, or {@code defaultValue} if absent. */
    public double number(String key, double min, double max, double defaultValue) {
        try {
            double value = Double.parseDouble(text(key));
            // NaN fails both comparisons.
            return value >= min && value <= max ? value : defaultValue;
        } catch (NumberFormatException e) {
            return defaultValue;
        }
    }

    /** Returns the enum constant of the stored name, or {@code defaultValue} if absent. */
    public <E extends Enum<E>> E enumValue(String key, E defaultValue) {
        return Stream.of(defaultValue.getDeclaringClass().getEnumConstants()).filter(e -> e.name().equals(text(key)))
                .findFirst().orElse(defaultValue);
    }

    public void set(String key, Object value) {
        values.setProperty(key, value.toString());
    }

    /** Returns the recently opened scenes, latest first. */
    public List<Path> recent() {
        List<Path> files = new ArrayList<>();
        for (int i = 0; i < MAX_RECENT; i++) {
            String path = text("recent." + i);
            try {
                if (!path.isEmpty()) {
                    files.add(Path.of(path));
                }
            } catch (InvalidPathException e) {
                // Path of another operating system.
            }
        }
        return files;
    }

    /** Adds an opened or saved scene to the recent ones, and stores the preferences. */
    public void addRecent(Path scene) {
        List<Path> files = new ArrayList<>(recent());
        Path absolute = scene.toAbsolutePath().normalize();
        files.remove(absolute);
        files.addFirst(absolute);
        for (int i = 0; i < Math.min(MAX_RECENT, files.size()); i++) {
            set("recent." + i, files.get(i));
        }
        save();
    }

    /** Writes the preferences in the background. Ignores write failures. */
    public void save() {
        var snapshot = (Properties) values.clone();
        writeExecutor.execute(() -> {
            try {
                PrivateFolder.create(ParentFolder.of(file));
                AtomicFile.of(file).forOwnerOnly().write(out -> snapshot.store(out, "Lightning"));
            } catch (IOException e) {
                // Preferences are optional.
            }
        });
    }
}
