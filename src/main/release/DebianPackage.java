import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import java.util.zip.GZIPOutputStream;

/**
 * Adds to jpackage's tree of a {@code .deb} what desktops and Debian expect outside the program's folder: the command's own name, manual
 * pages, menu entry, file types, icons by theme, AppStream metadata, copyright and changelog.
 */
final class DebianPackage {
    /** Name of the package and its folder; another package may be called lightning. */
    static final String NAME = "lightning-relight";
    static final String MAIL = "lightning-relight@users.noreply.github.com";
    private static final String ID = "io.github.lightning_relight.Lightning";
    private static final String DESCRIPTION = " Editor and commands that light ray-traced scenes. They keep what each pixel was\n"
            + " computed from, so an edit of a light recomputes only what changed. Each image\n equals a full render in every bit.";
    /** Place of the byte of a gzip file that says how hard it was compressed, and the value for the hardest, which Java leaves out (RFC 1952). */
    private static final int GZIP_EXTRA_FLAGS = 8;
    private static final byte GZIP_HARDEST = 2;
    private static final Path RESOURCES = Path.of("src/main/release/linux");

    private final Path tree;
    private final Path home;
    private final Path share;

    /** @param tree folder with the unpacked package */
    DebianPackage(Path tree) {
        this.tree = tree;
        this.home = tree.resolve("opt").resolve(NAME);
        this.share = tree.resolve("usr/share");
    }

    /**
     * Adds all files.
     *
     * @param manual  folder with manual pages and completion, as the program's folder has it
     * @param icons   icons by side in pixels, as PNG
     * @param date    date of the release, such as 2026-01-01
     */
    void complete(Path manual, Map<Integer, byte[]> icons, String version, String date) throws IOException, NoSuchAlgorithmException {
        Files.createSymbolicLink(folder("usr/bin").resolve(NAME), Path.of("/opt", NAME, "bin/lightning"));
        addManual(manual);
        addDesktop(version, date);
        for (var icon : icons.entrySet()) {
            String side = icon.getKey() + "x" + icon.getKey();
            write(share.resolve("icons/hicolor").resolve(side).resolve("apps").resolve(ID + ".png"), icon.getValue());
        }
        Path doc = share.resolve("doc").resolve(NAME);
        write(doc.resolve("copyright"), Files.readAllBytes(RESOURCES.resolve("copyright")));
        write(doc.resolve("NEWS.gz"), compress(Files.readAllBytes(Path.of("docs/CHANGELOG.md"))));
        write(doc.resolve("changelog.gz"), compress(changelog(version, date).getBytes(StandardCharsets.UTF_8)));
        // jpackage's script for after a removal has no commands.
        Files.deleteIfExists(tree.resolve("DEBIAN/postrm"));
        Files.deleteIfExists(home.resolve("share/doc/copyright"));
        Files.deleteIfExists(home.resolve("share/doc"));
        addSums();
        setModes();
    }

    /** Adds the page of the program itself and its completion in the program's folder: their alternatives have the name lightning. */
    private void addManual(Path manual) throws IOException {
        try (Stream<Path> pages = Files.list(manual.resolve("man/man1"))) {
            for (Path page : pages.sorted().toList()) {
                String name = page.getFileName().toString();
                Path folder = name.equals("lightning.1") ? home.resolve("share") : share;
                write(folder.resolve("man/man1").resolve(name + ".gz"), compress(Files.readAllBytes(page)));
            }
        }
        String completion = "bash-completion/completions/lightning";
        write(home.resolve("share").resolve(completion), Files.readAllBytes(manual.resolve(completion)));
        write(home.resolve("share/zsh/vendor-completions/_lightning"), Files.readAllBytes(RESOURCES.resolve("_lightning")));
    }

    /** Moves menu entry and file types from the program's folder, and adds the metadata. */
    private void addDesktop(String version, String date) throws IOException {
        Path entry = home.resolve("lib").resolve(NAME + "-lightning.desktop");
        String text = Files.readString(entry).replaceAll("(?m)^Icon=.*$", "Icon=" + ID).strip() + "\n";
        write(share.resolve("applications").resolve(ID + ".desktop"), text.getBytes(StandardCharsets.UTF_8));
        Files.delete(entry);
        Path types = home.resolve("lib").resolve(NAME + "-lightning-MimeInfo.xml");
        write(share.resolve("mime/packages").resolve(NAME + ".xml"), Files.readAllBytes(types));
        Files.delete(types);
        String metadata = Files.readString(RESOURCES.resolve("metainfo.xml")).replace("VERSION", version).replace("DATE", date);
        write(share.resolve("metainfo").resolve(ID + ".metainfo.xml"), metadata.getBytes(StandardCharsets.UTF_8));
    }

    /** Writes the checksums with which {@code debsums} checks an installation, and the size of all files. */
    private void addSums() throws IOException, NoSuchAlgorithmException {
        var sums = new StringBuilder();
        long bytes = 0;
        try (Stream<Path> files = Files.walk(tree)) {
            for (Path file : files.filter(file -> Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)
                    && !file.startsWith(tree.resolve("DEBIAN"))).sorted().toList()) {
                byte[] content = Files.readAllBytes(file);
                bytes += content.length;
                sums.append(HexFormat.of().formatHex(MessageDigest.getInstance("MD5").digest(content))).append("  ")
                        .append(tree.relativize(file)).append('\n');
            }
        }
        Files.writeString(tree.resolve("DEBIAN/md5sums"), sums);
        Path control = tree.resolve("DEBIAN/control");
        Files.writeString(control, Files.readString(control)
                .replaceAll("(?m)^Installed-Size:.*$", "Installed-Size: " + (bytes + 1023) / 1024)
                .replaceAll("(?m)^Description:.*$", "$0\n" + DESCRIPTION));
    }

    /** Sets the modes that Debian expects, whatever the umask of the build. */
    private void setModes() throws IOException {
        try (Stream<Path> files = Files.walk(tree)) {
            for (Path file : files.filter(file -> !Files.isSymbolicLink(file)).toList()) {
                boolean runs = Files.isDirectory(file) || Files.isExecutable(file);
                Files.setPosixFilePermissions(file, PosixFilePermissions.fromString(runs ? "rwxr-xr-x" : "rw-r--r--"));
            }
        }
    }

    /** Returns a changelog in Debian's own format. */
    private static String changelog(String version, String date) {
        String time =
                LocalDate.parse(date).atStartOfDay(ZoneOffset.UTC).format(DateTimeFormatter.RFC_1123_DATE_TIME).replace("GMT", "+0000");
        return NAME + " (" + version + ") stable; urgency=medium\n\n  * Version " + version + ". NEWS.gz lists the changes.\n\n -- "
                + "Lightning <" + MAIL + ">  " + time + "\n";
    }

    private Path folder(String name) throws IOException {
        return Files.createDirectories(tree.resolve(name));
    }

    private static void write(Path file, byte[] content) throws IOException {
        Files.createDirectories(file.getParent());
        Files.write(file, content);
    }

    private static byte[] compress(byte[] content) throws IOException {
        var bytes = new ByteArrayOutputStream();
        try (OutputStream out = new GZIPOutputStream(bytes) {
            {
                def.setLevel(9);
            }
        }) {
            out.write(content);
        }
        byte[] result = bytes.toByteArray();
        result[GZIP_EXTRA_FLAGS] = GZIP_HARDEST;
        return result;
    }

    /** Returns the commands that unpack a package and pack it again. */
    static List<List<String>> commands(Path file, Path tree) {
        return List.of(List.of("dpkg-deb", "--raw-extract", file.toString(), tree.toString()),
                List.of("dpkg-deb", "--root-owner-group", "--build", tree.toString(), file.toString()));
    }
}
