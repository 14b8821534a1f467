package lightning.edit;

import java.io.IOException;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemNotFoundException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.file.PrivateFolder;
import lightning.file.SafeFile;

/**
 * A folder that keeps unsaved scenes for the case of a crash: for each open document one file, the text of the scene
 * behind a line that names the process and the scene's own file. Nobody but their owner may read them.
 *
 * <p>A file whose process has ended was left behind by a crash. A process is told by its number and the moment that it
 * started, for numbers come again.
 */
public final class Recovery {
    private static final String HEAD = "# Lightning kept this of process ";
    private static final String OF = " for ";
    private static final String ENDING = ".kept.jen";
    /** More than the text of any scene and its head: what is larger was not kept here. */
    private static final long MOST_BYTES = 128L << 20;

    private final Path folder;
    private final String process;

    /** @param folder made when the first scene is kept */
    public Recovery(Path folder) {
        this(folder, name(ProcessHandle.current()));
    }

    Recovery(Path folder, String process) {
        this.folder = folder;
        this.process = process;
    }

    /**
     * A scene that a crash left unsaved.
     *
     * @param kept the file in the recovery folder
     * @param file the scene's own file, absolute
     * @param text what that file would hold if it had been saved
     */
    public record Found(Path kept, Path file, String text) {
        /** Forgets it. */
        public void delete() throws IOException {
            Files.deleteIfExists(kept);
        }
    }

    /**
     * Keeps the text of a scene, in place of what was kept for the same file.
     *
     * @throws IOException if it cannot be written; what was kept before is then still there
     */
    public void keep(Path file, String text) throws IOException {
        PrivateFolder.close(folder);
        String head = HEAD + process + OF + file.toAbsolutePath().toUri() + "\n";
        SafeFile.at(kept(file)).forOwnerOnly().write((head + text).getBytes(StandardCharsets.UTF_8));
    }

    /** Forgets what this process kept for a file: it was saved, or closed on purpose. */
    public void forget(Path file) throws IOException {
        Files.deleteIfExists(kept(file));
    }

    /** Takes over what a crash left as this process's own: it is there at every moment, and found by nobody else. */
    public void adopt(Found found) throws IOException {
        keep(found.file(), found.text());
        found.delete();
    }

    /** What crashed processes left, the latest first. A file that cannot be read is passed over. */
    public List<Found> found() throws IOException {
        List<Found> all = new ArrayList<>();
        if (Files.isDirectory(folder)) {
            try (Stream<Path> files = Files.list(folder)) {
                for (Path kept : files.filter(Recovery::mayBeKept).toList()) {
                    read(kept).ifPresent(all::add);
                }
            }
        }
        all.sort((a, b) -> Long.compare(b.kept().toFile().lastModified(), a.kept().toFile().lastModified()));
        return all;
    }

    private Optional<Found> read(Path kept) {
        try {
            String content = Files.readString(kept);
            int line = content.indexOf('\n');
            int of = content.indexOf(OF, HEAD.length());
            if (!content.startsWith(HEAD) || of < 0 || of > line) {
                return Optional.empty();
            }
            String owner = content.substring(HEAD.length(), of);
            Path file = path(content.substring(of + OF.length(), line));
            boolean nameless = !file.isAbsolute() || file.getFileName() == null;
            return nameless || isAlive(owner) ? Optional.empty() : Optional.of(new Found(kept, file, content.substring(line + 1)));
        } catch (IOException | IllegalArgumentException | FileSystemNotFoundException e) {
            return Optional.empty();
        }
    }

    private static boolean mayBeKept(Path file) {
        return file.getFileName().toString().endsWith(ENDING) && Files.isRegularFile(file)
                && file.toFile().length() <= MOST_BYTES;
    }

    /** As a URI, which has no line ends; older versions wrote the bare path. */
    private static Path path(String written) {
        return written.startsWith("file:") ? Path.of(URI.create(written)) : Path.of(written);
    }

    private Path kept(Path file) {
        String path = file.toAbsolutePath().toString();
        return folder.resolve(process + "-" + Integer.toHexString(path.hashCode()) + ENDING);
    }

    private static boolean isAlive(String owner) {
        int dash = owner.indexOf('-');
        try {
            return ProcessHandle.of(Long.parseLong(dash < 0 ? owner : owner.substring(0, dash))).filter(ProcessHandle::isAlive)
                    .map(Recovery::name).filter(owner::equals).isPresent();
        } catch (NumberFormatException e) {
            return false;
        }
    }

    private static String name(ProcessHandle handle) {
        return handle.pid() + handle.info().startInstant().map(t -> "-" + t.toEpochMilli()).orElse("");
    }
}
