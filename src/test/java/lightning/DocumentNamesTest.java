package lightning;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Tests that the documents name packages and classes that exist. */
class DocumentNamesTest {
    private static final Path DOCUMENTS = Path.of("docs");
    private static final Pattern DECLARATION = Pattern.compile("(?:class|record|interface|enum) ([A-Z]\\w*)");
    private static final Pattern PACKAGE = Pattern.compile("(?m)^package lightning\\.?([\\w.]*);");
    /**
     * A class name in backticks, with a member if one follows: after a package of this program, or alone. Alone, only a name of two words
     * is taken for a class.
     */
    private static final Pattern NAME = Pattern.compile(
            "`(?:lightning\\.)?(?:((?!java|jdk|org|com)(?:[a-z]+\\.)+)([A-Z]\\w+)|([A-Z][a-z0-9]+[A-Z]\\w*))(?:\\.(\\w+))?(?:[.(:][^`]*)?`");
    /** Line of a page with names of classes that were renamed or removed after it was written. */
    private static final Pattern OLD_NAMES = Pattern.compile("(?m)^Names? at that time: (.*)$");
    /** Packages of Java and JavaFX whose classes the documents name alone. */
    private static final List<String> LIBRARIES =
            List.of("java.lang", "java.lang.invoke", "java.util", "java.util.concurrent", "java.nio.file",
                    "javafx.scene.control", "jdk.incubator.vector");
    /** Names of options of Java, of file formats, and of other programs. */
    private static final Set<String> OTHERS = Set.of("G1ExpandByPercentOfAvailable", "G1HeapRegionSize", "G1NewSizePercent",
            "G1PeriodicGCInterval", "MaxHeapFreeRatio", "NodeCountInliningCutoff", "PrintInlining", "VerifySharedSpaces", "VmHWM",
            "UsdLuxBlackbodyTemperatureAsRgb", "UsdPreviewSurface", "PointInstancer", "DistantLight", "SphereLight", "DiskLight",
            "RectLight",
            "CylinderLight", "DomeLight", "DomeLight_1", "ShapingAPI", "MeshLightAPI", "CryptoObject00", "CryptoMaterial00",
            "CryptoAsset00");

    /** Sources of each class of the program, its tests and its benchmarks, by simple name. */
    private static final Map<String, String> SOURCES = new HashMap<>();
    /** Packages of each class of the program, its tests and its benchmarks, by simple name. */
    private static final Map<String, Set<String>> CLASSES = classes();

    private static Map<String, Set<String>> classes() {
        Map<String, Set<String>> found = new HashMap<>();
        for (Path root : List.of(Path.of("src"), Path.of("benchmarks"))) {
            for (Path file : files(root, ".java")) {
                String source = read(file);
                Matcher header = PACKAGE.matcher(source);
                String name = header.find() ? header.group(1) : "";
                add(found, file.getFileName().toString().replace(".java", ""), name);
                DECLARATION.matcher(source).results().forEach(m -> {
                    add(found, m.group(1), name);
                    SOURCES.merge(m.group(1), source, String::concat);
                });
                if (source.contains("@RecordBuilder")) {
                    add(found, file.getFileName().toString().replace(".java", "Builder"), name);
                }
            }
        }
        return found;
    }

    private static void add(Map<String, Set<String>> found, String type, String name) {
        found.computeIfAbsent(type, _ -> new TreeSet<>()).add(name);
    }

    private static List<Path> files(Path folder, String extension) {
        try (Stream<Path> all = Files.walk(folder)) {
            return all.filter(file -> file.toString().endsWith(extension)).sorted().toList();
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    private static String read(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    private static List<Path> pages() {
        return files(DOCUMENTS, ".md").stream().filter(page -> !page.endsWith("CHANGELOG.md")).toList();
    }

    private static boolean isOfLibrary(String name) {
        return OTHERS.contains(name) || LIBRARIES.stream().anyMatch(library -> {
            try {
                Class.forName(library + "." + name, false, DocumentNamesTest.class.getClassLoader());
                return true;
            } catch (ClassNotFoundException e) {
                return false;
            }
        });
    }

    /**
     * Class that a document names.
     *
     * @param inside package as written, with a dot at its end; empty for none
     * @param member method, field or nested class that follows; null for none
     */
    private record Mention(String inside, String name, String member) {
        private static Stream<Mention> in(String text) {
            return NAME.matcher(text).results()
                    .map(m -> m.group(3) == null
                            ? new Mention(m.group(1), m.group(2), m.group(4)) : new Mention("", m.group(3), m.group(4)));
        }

        /** Returns whether the program has the class, in that package if there is one. */
        private boolean isPresent() {
            return CLASSES.getOrDefault(name, Set.of()).stream().anyMatch(p -> ("." + p + ".").endsWith("." + inside));
        }

        /** Returns whether the class has the member, if there is one; copy methods of records are generated. */
        private boolean hasMember() {
            return member == null || !SOURCES.containsKey(name) || member.matches("with[A-Z].*|java")
                    || Pattern.compile("\\b" + member + "\\b").matcher(SOURCES.get(name)).find();
        }

        @Override
        public String toString() {
            return inside + name + (CLASSES.containsKey(name) ? ", which is in " + CLASSES.get(name) : "");
        }
    }

    @Test
    void classes_exist() {
        List<String> missing = new ArrayList<>();
        for (Path page : pages()) {
            String text = read(page);
            String old = OLD_NAMES.matcher(text).results().map(m -> m.group(1)).collect(Collectors.joining());
            Mention.in(text).filter(m -> !m.isPresent() && !(m.inside().isEmpty() && isOfLibrary(m.name())))
                    .filter(m -> !old.contains("`" + m.name() + "`")).forEach(m -> missing.add(page + ": " + m));
        }
        assertThat(missing).as("Write the present name, or add a line \"Names at that time: `Name`, ….\" to the page:\n"
                + String.join("\n", missing)).isEmpty();
    }

    @Test
    void members_exist() {
        List<String> missing = new ArrayList<>();
        for (Path page : pages()) {
            Mention.in(read(page)).filter(m -> !m.hasMember()).forEach(m -> missing.add(page + ": " + m.name() + "." + m.member()));
        }
        assertThat(missing).as(String.join("\n", missing)).isEmpty();
    }

    /** Packages change more often than classes, and decisions stay. */
    @Test
    void decisions_nameClassesWithoutPackages() {
        List<String> wrong = new ArrayList<>();
        for (Path page : files(DOCUMENTS.resolve("decisions"), ".md")) {
            Mention.in(read(page)).filter(m -> !m.inside().isEmpty() && CLASSES.containsKey(m.name()))
                    .forEach(m -> wrong.add(page + ": " + m.inside() + m.name()));
        }
        assertThat(wrong).isEmpty();
    }

    @Test
    void architecture_namesAllPackages() {
        Set<String> named = packagesInArchitecture();
        Set<String> existing = PackageTable.read().rows().stream().map(PackageTable.Row::name).filter(name -> !name.startsWith("("))
                .collect(Collectors.toCollection(TreeSet::new));
        Set<String> parents = new HashSet<>();
        existing.forEach(name -> {
            for (int dot = name.lastIndexOf('.'); dot > 0; dot = name.lastIndexOf('.', dot - 1)) {
                parents.add(name.substring(0, dot));
            }
        });
        assertThat(existing).as("packages that the table of docs/architecture.md lacks").isSubsetOf(named);
        named.removeAll(existing);
        assertThat(named).as("packages of the table of docs/architecture.md that do not exist").isSubsetOf(parents);
    }

    /** Returns the packages in the last column of the table; those in parentheses are inside the one named before. */
    private static Set<String> packagesInArchitecture() {
        Set<String> names = new TreeSet<>();
        Pattern token = Pattern.compile("`([a-z.]+)`|[()]");
        read(DOCUMENTS.resolve("architecture.md")).lines().filter(line -> line.matches("\\| `\\w+` \\| .* \\| .* \\|")).forEach(line -> {
            String[] cells = line.split("\\|");
            String group = cells[1].strip().replace("`", "");
            if (PackageTable.GROUPS.contains(group)) {
                Deque<String> open = new ArrayDeque<>(List.of(group));
                String last = group;
                for (Matcher m = token.matcher(cells[3]); m.find();) {
                    switch (m.group()) {
                        case "(" -> open.push(last);
                        case ")" -> open.pop();
                        default -> {
                            last = m.group(1).equals(group) && open.size() == 1 ? group : open.peek() + "." + m.group(1);
                            names.add(last);
                        }
                    }
                }
            }
        });
        return names;
    }
}
