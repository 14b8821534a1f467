package lightning.base.file;

import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;

/** Folder for files that the program can make again. */
public final class CacheFolder {
    private CacheFolder() {}

    /** Returns this user's folder, which may not exist. */
    public static Path ofUser() {
        return of(System.getProperty("os.name"), Path.of(System.getProperty("user.home")), System.getenv());
    }

    /**
     * Returns a user's folder: in {@code XDG_CACHE_HOME} or {@code ~/.cache} on Linux, in {@code ~/Library/Caches} on macOS, and in
     * {@code LOCALAPPDATA} on Windows.
     *
     * @param system name of the operating system
     */
    static Path of(String system, Path home, Map<String, String> environment) {
        String name = system.toLowerCase(Locale.ROOT);
        if (name.startsWith("mac")) {
            return home.resolve("Library", "Caches", "Lightning");
        }
        if (name.startsWith("windows")) {
            String local = environment.get("LOCALAPPDATA");
            return (local == null ? home.resolve("AppData", "Local") : Path.of(local)).resolve("Lightning", "Cache");
        }
        // A relative path counts as none: XDG Base Directory Specification.
        String cache = environment.getOrDefault("XDG_CACHE_HOME", "");
        return (cache.startsWith("/") ? Path.of(cache) : home.resolve(".cache")).resolve("lightning");
    }
}
