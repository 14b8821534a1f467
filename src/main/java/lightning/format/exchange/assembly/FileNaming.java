package lightning.format.exchange.assembly;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Supplier;
import lightning.base.file.ParentFolder;
import lightning.base.text.Quote;
import org.jspecify.annotations.Nullable;

/**
 * Names for the files of an imported scene that leave the user's files as they are. A file keeps its name if no other file has it, or only one
 * that an earlier import wrote for this scene, that has not changed since and that no other scene of the folder uses. Else it gets a number.
 */
final class FileNaming {
    private final Path folder;
    private final WrittenFiles written;
    private final Supplier<OtherScenes> others;
    private final Set<Path> taken = new HashSet<>();
    private final Map<String, String> newNames = new HashMap<>();
    private final List<AssetCopy> copies = new ArrayList<>();
    private final List<String> comments = new ArrayList<>();

    /** @param sceneFile scene file, whose comments say what an earlier import wrote */
    FileNaming(Path sceneFile) {
        folder = ParentFolder.of(sceneFile);
        written = WrittenFiles.findIn(sceneFile);
        others = new Supplier<>() {
            private @Nullable OtherScenes scenes;

            @Override
            public OtherScenes get() {
                scenes = scenes == null ? OtherScenes.nextTo(sceneFile) : scenes;
                return scenes;
            }
        };
    }

    /**
     * Adds a file.
     *
     * @throws IOException if it needs another name, and files other than the scene refer to it
     */
    void add(AssetCopy copy, boolean canBeRenamed) throws IOException {
        String requested = name(copy.target());
        AssetCopy named = copy;
        for (int i = 2; !isFree(named); i++) {
            if (!canBeRenamed) {
                throw new IOException(Quote.path(copy.target()) + ": already exists with other content; import into another folder");
            }
            named = copy.to(copy.target().resolveSibling(i + " " + copy.target().getFileName()));
        }
        String name = name(named.target());
        taken.add(named.target());
        newNames.put(requested, name);
        copies.add(named);
        if (!Files.exists(named.target()) || written.contains(name, named.target())) {
            comments.add(WrittenFiles.comment(name, requested, named.hash()));
        }
    }

    private boolean isFree(AssetCopy copy) throws IOException {
        Path target = copy.target();
        if (taken.contains(target)) {
            return false;
        }
        return !Files.exists(target, LinkOption.NOFOLLOW_LINKS) || Files.isRegularFile(target) && copy.isWritten()
                || written.contains(name(target), target) && !others.get().mayUse(target.getFileName().toString());
    }

    private String name(Path target) {
        return nameIn(folder, target);
    }

    /** Returns the name of a file by which a scene in a folder references it. */
    static String nameIn(Path folder, Path target) {
        List<String> parts = new ArrayList<>();
        folder.relativize(target).forEach(part -> parts.add(part.toString()));
        return String.join("/", parts);
    }

    /** Returns the files at their new places. */
    List<AssetCopy> copies() {
        return List.copyOf(copies);
    }

    /** Returns the new name of a file of the scene. */
    String newName(String name) {
        return newNames.getOrDefault(name, name);
    }

    /** Returns names that differ: the requested one with the new one. */
    Map<String, String> renamed() {
        var renamed = new TreeMap<>(newNames);
        renamed.entrySet().removeIf(entry -> entry.getKey().equals(entry.getValue()));
        return renamed;
    }

    /** Returns comments for the scene file, which the next import reads. */
    List<String> comments() {
        return List.copyOf(comments);
    }
}
