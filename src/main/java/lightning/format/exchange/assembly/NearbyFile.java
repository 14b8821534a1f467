package lightning.format.exchange.assembly;

import java.io.IOException;
import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;
import lightning.base.file.FolderEntry;
import lightning.base.file.ParentFolder;
import lightning.base.file.RegularFile;

/**
 * Search for a file that another file names, in its folder and below. Names of other systems are found, too: with backslashes, in another
 * case, with characters of a URI as codes or not. Of a path that leads elsewhere, only its last name is looked for.
 *
 * @param folder folder of the naming file, without links in its path
 */
record NearbyFile(Path folder) {
    /** @throws IOException if the folder cannot be resolved */
    static NearbyFile of(Path source) throws IOException {
        return new NearbyFile(ParentFolder.of(source).toRealPath());
    }

    /** Returns a regular file that a reference names; empty if there is none. */
    Optional<Path> find(String reference) throws IOException {
        for (String spelling : spellings(reference)) {
            Optional<Path> found = findPath(spelling);
            if (found.isPresent()) {
                return found;
            }
        }
        return Optional.empty();
    }

    /** Returns spellings of a reference, the most faithful first. */
    private static Set<String> spellings(String reference) {
        Set<String> spellings = new LinkedHashSet<>();
        for (String text : new String[] {decoded(reference), reference}) {
            String slashes = text.replace('\\', '/');
            spellings.add(text);
            spellings.add(slashes);
            spellings.add(slashes.substring(slashes.lastIndexOf('/') + 1));
        }
        return spellings;
    }

    /** Decodes codes of a URI; a plus sign is literal in paths. */
    private static String decoded(String reference) {
        try {
            return URLDecoder.decode(reference.replace("+", "%2B"), StandardCharsets.UTF_8);
        } catch (IllegalArgumentException e) {
            return reference;
        }
    }

    private Optional<Path> findPath(String spelling) throws IOException {
        try {
            Path path = folder.resolve(spelling).normalize();
            if (spelling.isEmpty() || !path.startsWith(folder) || path.equals(folder)) {
                return Optional.empty();
            }
            Optional<Path> entry = FolderEntry.find(folder, folder.relativize(path));
            return entry.isPresent() && RegularFile.describeIrregular(entry.get()).isEmpty() && entry.get().toRealPath().startsWith(folder)
                    ? entry : Optional.empty();
        } catch (InvalidPathException e) {
            return Optional.empty();
        }
    }
}
