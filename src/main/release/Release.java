import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.RoundRectangle2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.imageio.ImageIO;

/**
 * Builder of an installable image that includes Java, run by {@code mvn -Prelease package}. Arguments: the program's folder, the release
 * folder, version, time of the sources, and package type ({@code deb}, {@code rpm}, {@code msi}, {@code dmg}). The build is reproducible:
 * all files have the sources' time, and the class archive comes from a list that is part of the release.
 */
final class Release {
    /** Java modules of the program and its libraries; the last has the number formats of other countries. */
    private static final String MODULES = "java.desktop,java.logging,java.management,java.sql,java.xml,jdk.incubator.vector,"
            + "jdk.management,jdk.unsupported,jdk.localedata";
    private static final String SUMMARY = "Interactive lighting of ray-traced scenes";
    /** Packages that JavaFX loads by name, which no tool can detect; the second names are those with 64-bit time. */
    private static final String DEBIAN = "libgtk-3-0 | libgtk-3-0t64, libfreetype6, libpangoft2-1.0-0, libxtst6, libxxf86vm1";
    private static final int[] ICON_SIDES = {16, 32, 48, 64, 128, 256};

    private final Path program;
    private final Path made;
    private final Path shipped;
    private final String version;
    private final FileTime time;
    private final String kind;

    private Release(Path program, Path made, String version, Instant time, String kind) {
        this.program = program;
        this.made = made;
        this.shipped = made.resolve("shipped");
        this.version = version;
        this.time = FileTime.from(time);
        this.kind = kind;
    }

    public static void main(String[] args) throws Exception {
        var release = new Release(Path.of(args[0]), Path.of(args[1]), args[2], Instant.parse(args[3]), args[4]);
        release.clear();
        release.link();
        release.ship();
        release.archive();
        release.pack();
        if (release.kind.equals("deb")) {
            release.completeDebian();
        }
        release.sum();
    }

    /** Removes the output of an earlier run; keeps files of other tools, such as the bill of materials. */
    private void clear() throws IOException {
        for (String folder : List.of("runtime", "shipped", "training", "temporary", "associations", "debian")) {
            remove(made.resolve(folder));
        }
        Files.createDirectories(made.resolve("dist"));
        try (Stream<Path> old = Files.list(made.resolve("dist"))) {
            for (Path file : old.filter(file -> file.toString().endsWith("." + kind)).toList()) {
                Files.delete(file);
            }
        }
    }

    /** Links a Java with only these modules, and the archive of its own classes. */
    private void link() throws IOException, InterruptedException {
        run("jlink", "--add-modules", MODULES, "--output", made.resolve("runtime").toString(), "--no-header-files", "--no-man-pages",
                "--strip-debug", "--generate-cds-archive");
    }

    /** Collects the files of the installed program. */
    private void ship() throws IOException {
        copy(program.resolve("lib"), shipped);
        copy(program.resolve("cluster"), shipped);
        for (String folder : List.of("scenes", "textures", "licences", "python", "blender")) {
            copy(program.resolve(folder), shipped.resolve(folder));
        }
        for (String file : List.of("licences.txt", "LICENSE")) {
            Files.copy(program.resolve(file), shipped.resolve(file));
        }
        setTimes(shipped);
    }

    /**
     * Creates the class archive, from the list of another build if {@code LIGHTNING_CLASSES} names one. The list is part of the release:
     * with it, anyone can build the same archive.
     */
    private void archive() throws IOException, InterruptedException {
        Path training = Files.createDirectories(made.resolve("training"));
        Path list = made.resolve("dist/lightning-relight-" + version + ".classes");
        String other = System.getenv("LIGHTNING_CLASSES");
        Files.write(list, other == null || other.isEmpty() ? train(training) : Files.readAllLines(Path.of(other)));
        java(training, "-Xshare:dump", "-XX:SharedClassListFile=" + list.toAbsolutePath(),
                "-XX:SharedArchiveFile=" + shipped.resolve("lightning.jsa").toAbsolutePath());
        Files.setLastModifiedTime(shipped.resolve("lightning.jsa"), time);
    }

    /**
     * Returns the classes that a training start loads, sorted, without hints that depend on the order of its threads. Some classes are loaded
     * only by a fast start, or by one whose threads wait for each other, so two lists can differ.
     */
    private List<String> train(Path training) throws IOException, InterruptedException {
        Path loaded = training.resolve("classes");
        java(training, "-XX:DumpLoadedClassList=" + loaded.toAbsolutePath(), "-Dlightning.home=" + shipped.toAbsolutePath(),
                "-Dlightning.data=" + training.resolve("data").toAbsolutePath(), "-Dglass.platform=Headless", "-Dprism.order=sw",
                "lightning.ArchiveTraining", training.resolve("picture.png").toAbsolutePath().toString());
        return Files.readAllLines(loaded).stream().filter(line -> !line.startsWith("#") && !line.startsWith("@cp"))
                .map(line -> line.replaceFirst(" id: .*", "")).distinct().sorted().toList();
    }

    /** Runs the linked Java in the folder of the shipped files, on the class path of the launcher. */
    private void java(Path logs, String... words) throws IOException, InterruptedException {
        List<String> line = new ArrayList<>(List.of(made.resolve("runtime/bin/java").toAbsolutePath().toString()));
        line.addAll(options());
        line.addAll(List.of("-cp", jars().stream().map(jar -> shipped.resolve(jar).toAbsolutePath().toString())
                .collect(Collectors.joining(File.pathSeparator))));
        line.addAll(List.of(words));
        Path log = logs.resolve("log");
        ProcessBuilder builder =
                new ProcessBuilder(line).directory(shipped.toFile()).redirectErrorStream(true).redirectOutput(log.toFile());
        // The archive contains texts that depend on the user's language and encoding.
        builder.environment().put("LC_ALL", "C.UTF-8");
        Process process = builder.start();
        if (process.waitFor() != 0) {
            throw new IOException(String.join(" ", line) + " exited with code " + process.exitValue() + ":\n" + Files.readString(log));
        }
    }

    private void pack() throws IOException, InterruptedException {
        List<String> line = new ArrayList<>(List.of("--type", kind, "--name", name(), "--app-version", version, "--dest",
                made.resolve("dist").toString(), "--temp", made.resolve("temporary").toString(), "--input", shipped.toString(),
                "--runtime-image", made.resolve("runtime").toString(), "--main-jar", "lightning.jar", "--main-class", "lightning.Main",
                "--vendor", "Lightning", "--description", SUMMARY, "--icon", icon().toString()));
        List<String> java = new ArrayList<>(options());
        java.addAll(List.of("-Dlightning.home=$APPDIR", "-XX:SharedArchiveFile=$APPDIR/lightning.jsa", "-Xlog:cds*=off", "-Xlog:aot*=off"));
        java.forEach(option -> line.addAll(List.of("--java-options", option)));
        if (!kind.equals("dmg")) {
            line.addAll(List.of("--license-file", "LICENSE"));
        }
        associate(line, "jen", "text/x-lightning-scene", "Lightning scene");
        associate(line, "glb", "model/gltf-binary", "glTF scene");
        switch (kind) {
            case "deb" -> line.addAll(List.of("--linux-shortcut", "--linux-menu-group", "Graphics", "--linux-app-category", "graphics",
                    "--linux-package-deps", DEBIAN, "--linux-package-name", DebianPackage.NAME, "--linux-deb-maintainer",
                    DebianPackage.MAIL,
                    "--resource-dir",
                    "src/main/release/linux"));
            case "rpm" ->
                    line.addAll(List.of("--linux-shortcut", "--linux-menu-group", "Graphics", "--resource-dir", "src/main/release/linux"));
            case "msi" -> line.addAll(List.of("--win-menu", "--win-shortcut-prompt", "--win-dir-chooser", "--win-console"));
            case "dmg" -> line.addAll(List.of("--mac-app-category", "graphics-design"));
            default -> throw new IllegalArgumentException("expected a package of kind deb, rpm, msi or dmg, found " + kind);
        }
        run("jpackage", line.toArray(String[]::new));
    }

    /** Adds to the package what belongs outside the program's folder. */
    private void completeDebian() throws IOException, InterruptedException, NoSuchAlgorithmException {
        Path file;
        try (Stream<Path> files = Files.list(made.resolve("dist"))) {
            file = files.filter(found -> found.toString().endsWith(".deb")).findFirst().orElseThrow();
        }
        Path tree = made.resolve("debian");
        List<List<String>> commands = DebianPackage.commands(file, tree);
        start(commands.getFirst());
        BufferedImage whole = ImageIO.read(Path.of("src/main/release/icon.png").toFile());
        Map<Integer, byte[]> icons = new TreeMap<>();
        for (int side : ICON_SIDES) {
            icons.put(side, png(whole, side));
        }
        new DebianPackage(tree).complete(program.resolve("share"), icons, version, time.toString().substring(0, 10));
        start(commands.getLast());
    }

    /** Returns the program's name in each system's convention. */
    private String name() {
        return kind.equals("deb") || kind.equals("rpm") ? "lightning" : "Lightning";
    }

    private void associate(List<String> line, String extension, String type, String description) throws IOException {
        Path file = Files.createDirectories(made.resolve("associations")).resolve(extension + ".properties");
        Files.writeString(file, "extension=" + extension + "\nmime-type=" + type + "\ndescription=" + description + "\n");
        line.addAll(List.of("--file-associations", file.toString()));
    }

    /** Returns the launcher's Java options. */
    private List<String> options() throws IOException {
        return Files.readAllLines(program.resolve("bin/java.options")).stream().filter(line -> line.startsWith("-")).toList();
    }

    /** Returns the class path in jpackage's order: the program, then its libraries by name. */
    private List<String> jars() throws IOException {
        try (Stream<Path> files = Files.list(shipped)) {
            Stream<String> libraries = files.map(file -> file.getFileName().toString())
                    .filter(file -> file.endsWith(".jar") && !file.equals("lightning.jar")).sorted();
            return Stream.concat(Stream.of("lightning.jar"), libraries).toList();
        }
    }

    /** Converts the icon, with rounded corners, to the system's format. */
    private Path icon() throws IOException {
        BufferedImage whole = ImageIO.read(Path.of("src/main/release/icon.png").toFile());
        return switch (kind) {
            case "msi" -> Files.write(made.resolve("lightning.ico"), ico(whole));
            case "dmg" -> Files.write(made.resolve("lightning.icns"), icns(whole));
            default -> Files.write(made.resolve("lightning.png"), png(whole, 256));
        };
    }

    private static byte[] png(BufferedImage whole, int side) throws IOException {
        var image = new BufferedImage(side, side, BufferedImage.TYPE_INT_ARGB);
        Graphics2D graphics = image.createGraphics();
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setColor(Color.BLACK);
        graphics.fill(new RoundRectangle2D.Double(0, 0, side, side, side * 0.36, side * 0.36));
        graphics.setComposite(java.awt.AlphaComposite.SrcIn);
        graphics.drawImage(whole.getScaledInstance(side, side, java.awt.Image.SCALE_AREA_AVERAGING), 0, 0, null);
        graphics.dispose();
        var out = new ByteArrayOutputStream();
        ImageIO.write(image, "png", out);
        return out.toByteArray();
    }

    /** Encodes Windows' format: a directory of 16 bytes for each size, then the sizes as PNG. */
    private static byte[] ico(BufferedImage whole) throws IOException {
        List<byte[]> pictures = new ArrayList<>();
        for (int side : ICON_SIDES) {
            pictures.add(png(whole, side));
        }
        int offset = 6 + 16 * pictures.size();
        ByteBuffer bytes =
                ByteBuffer.allocate(offset + pictures.stream().mapToInt(picture -> picture.length).sum()).order(ByteOrder.LITTLE_ENDIAN);
        bytes.putShort((short) 0).putShort((short) 1).putShort((short) pictures.size());
        for (int i = 0; i < ICON_SIDES.length; i++) {
            byte side = (byte) ICON_SIDES[i];
            bytes.put(side).put(side).putShort((short) 0).putShort((short) 1).putShort((short) 32).putInt(pictures.get(i).length)
                    .putInt(offset);
            offset += pictures.get(i).length;
        }
        pictures.forEach(bytes::put);
        return bytes.array();
    }

    /** Encodes macOS' format: each size as PNG after its type and length; ic07 to ic09 are 128 to 512 pixels. */
    private static byte[] icns(BufferedImage whole) throws IOException {
        var body = new ByteArrayOutputStream();
        for (int i = 0; i < 3; i++) {
            byte[] picture = png(whole, 128 << i);
            body.write(("ic0" + (7 + i)).getBytes(StandardCharsets.US_ASCII));
            body.write(ByteBuffer.allocate(4).putInt(picture.length + 8).array());
            body.write(picture);
        }
        return ByteBuffer.allocate(body.size() + 8).put("icns".getBytes(StandardCharsets.US_ASCII)).putInt(body.size() + 8)
                .put(body.toByteArray())
                .array();
    }

    /** Writes the SHA-256 sums of all released files, for {@code sha256sum --check}. */
    private void sum() throws IOException, NoSuchAlgorithmException {
        Path sums = made.resolve("dist/SHA256SUMS");
        var text = new StringBuilder();
        try (Stream<Path> files = Files.list(made.resolve("dist"))) {
            for (Path file : files.filter(file -> !file.equals(sums)).sorted().toList()) {
                byte[] digest = MessageDigest.getInstance("SHA-256").digest(Files.readAllBytes(file));
                text.append(HexFormat.of().formatHex(digest)).append("  ").append(file.getFileName()).append('\n');
            }
        }
        Files.writeString(sums, text);
    }

    /** Runs a tool of this Java in its own process: jlink writes other bytes in a process that has run other code. */
    private void run(String tool, String... words) throws IOException, InterruptedException {
        List<String> line = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", tool).toString()));
        line.addAll(List.of(words));
        start(line);
    }

    private void start(List<String> line) throws IOException, InterruptedException {
        ProcessBuilder process = new ProcessBuilder(line).inheritIO();
        // Packaging tools limit file times to this.
        process.environment().put("SOURCE_DATE_EPOCH", Long.toString(time.to(TimeUnit.SECONDS)));
        int code = process.start().waitFor();
        if (code != 0) {
            throw new IOException(line.getFirst() + " exited with code " + code);
        }
    }

    private static void copy(Path from, Path to) throws IOException {
        try (Stream<Path> files = Files.walk(from)) {
            for (Path file : files.sorted().toList()) {
                Path target = to.resolve(from.relativize(file).toString());
                if (Files.isDirectory(file)) {
                    Files.createDirectories(target);
                } else {
                    Files.copy(file, target);
                }
            }
        }
    }

    private void setTimes(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.toList()) {
                Files.setLastModifiedTime(file, time);
            }
        }
    }

    private static void remove(Path folder) throws IOException {
        if (!Files.exists(folder)) {
            return;
        }
        Files.walkFileTree(folder, new SimpleFileVisitor<>() {
            @Override
            public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) throws IOException {
                file.toFile().setWritable(true);
                Files.delete(file);
                return FileVisitResult.CONTINUE;
            }

            @Override
            public FileVisitResult postVisitDirectory(Path directory, IOException error) throws IOException {
                Files.delete(directory);
                return FileVisitResult.CONTINUE;
            }
        });
    }
}
