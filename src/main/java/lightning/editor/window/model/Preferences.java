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
import lightning.base.file.PrivateFolder;

/**
 * What the editor remembers from one run to the next. A value that is damaged, or beyond what its reader can use, counts
 * as absent, and so does all of a file that cannot be read; the other values stay.
 */
public final class Preferences {
    private static final int MAX_RECENT = 10;
    private static final int MAX_BYTES = 1 << 20;
    /** A Unicode escape without its four digits, which the reader of properties throws at. */
    private static final Pattern INVALID_ESCAPE = Pattern.compile("(?<!\\\\)(?:\\\\\\\\)*+\\\\u(?![0-9a-fA-F]{4})");

    private final Path file;
    private final Executor writeExecutor;
    private final Properties values = new Properties();

    /**
     * Reads them from a folder.
     *
     * @param writeExecutor does what takes a file, in turn
     */
    public Preferences(Path folder, Executor writeExecutor) {
        this.writeExecutor = writeExecutor;
        file = folder.resolve("preferences.properties");
        if (Files.isRegularFile(file)) {
            try (InputStream in = Files.newInputStream(file)) {
                String text = new String(in.readNBytes(MAX_BYTES), StandardCharsets.UTF_8);
                // Together, as each call takes 18 kB.
                values.load(new StringReader(
                        text.lines().filter(line -> !INVALID_ESCAPE.matcher(line).find()).map(Preferences::withoutContinuation)
                                .collect(Collectors.joining("\n"))));
            } catch (IOException e) {
                values.clear();
            }
        }
    }

    /** A line that does not go on in the next one: each value has a line, and what is wrong with one is no reason to lose another. */
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

    /** A text; {@code defaultValue} where there is none. */
    public String text(String key, String defaultValue) {
        return values.getProperty(key, defaultValue);
    }

    /** Whether a value is this one. */
    public boolean hasValue(String key, String value) {
        return text(key).equals(value);
    }

    /** A number from {@code min} to {@code max}; {@code defaultValue} where there is none. */
    public double number(String key, double min, double max, double defaultValue) {
        try {
            double value = Double.parseDouble(text(key));
            // NaN is not between any two numbers.
            return value >= min && value <= max ? value : defaultValue;
        } catch (NumberFormatException e) {
            return defaultValue;
        }
    }

    /** One of the values of {@code defaultValue}'s type, by its name; {@code defaultValue} where there is none. */
    public <E extends Enum<E>> E enumValue(String key, E defaultValue) {
        return Stream.of(defaultValue.getDeclaringClass().getEnumConstants()).filter(e -> e.name().equals(text(key)))
                .findFirst().orElse(defaultValue);
    }

    public void set(String key, Object value) {
        values.setProperty(key, value.toString());
    }

    /** The scenes opened last, the latest first. */
    public List<Path> recent() {
        List<Path> files = new ArrayList<>();
        for (int i = 0; i < MAX_RECENT; i++) {
            String path = text("recent." + i);
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

    /** Writes them as they are now. Preferences that cannot be kept are no reason to disturb anybody. */
    public void save() {
        var snapshot = (Properties) values.clone();
        writeExecutor.execute(() -> {
            try {
                PrivateFolder.create(file.toAbsolutePath().getParent());
                AtomicFile.of(file).forOwnerOnly().write(out -> snapshot.store(out, "Lightning"));
            } catch (IOException e) {
                // The next run starts without them.
            }
        });
    }
}
