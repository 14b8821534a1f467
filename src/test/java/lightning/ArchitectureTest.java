package lightning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.lang.ArchRule;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import lightning.sample.Slow;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Checks that the program follows {@link PackageTable} and {@link ArchitectureRules}, and that the rules detect violations. */
@Slow
class ArchitectureTest {
    private static final JavaClasses PROGRAM = PackageTable.program();
    private static final PackageTable PACKAGES = PackageTable.read();

    private static final Pattern CATCH = Pattern.compile("catch \\([^)]*\\bIllegalArgumentException\\b");

    @TempDir
    private Path folder;

    @Test
    void program_isImported() {
        assertThat(PROGRAM.contain("lightning.Main")).isTrue();
        assertThat(PROGRAM.contain("lightning.scene.Scene")).isTrue();
        assertThat(PROGRAM.contain("lightning.ArchitectureTest")).isFalse();
    }

    @Test
    void packages_importWhatTheTableAllows() {
        assertNone(PACKAGES.violations(PROGRAM));
    }

    @Test
    void packages_importAllThatTheTableAllows() {
        assertNone(PACKAGES.unused(PROGRAM));
    }

    @Test
    void packages_areBelowTheirImports() {
        assertNone(PACKAGES.forwardImports());
    }

    @Test
    void packages_areInGroupOrder() {
        assertNone(PACKAGES.outOfOrder());
    }

    private static void assertNone(List<String> messages) {
        assertThat(messages).as("\n" + String.join("\n", messages) + "\n").isEmpty();
    }

    /** Who catches an IllegalArgumentException shows bugs as refusals, unless a library throws it for foreign data. */
    @Test
    void illegalArguments_areCaughtOnlyFromLibraries() throws IOException {
        try (Stream<Path> files = Files.walk(Path.of("src/main/java"))) {
            List<String> catching = files.filter(file -> file.toString().endsWith(".java"))
                    .filter(file -> CATCH.matcher(read(file)).find()).map(file -> file.getFileName().toString()).sorted().toList();
            assertThat(catching).containsExactly("BufferReader.java", "ConeProfile.java", "KeyBindings.java", "MissingFolderFallback.java",
                    "NearbyFile.java", "NodeSession.java", "RecoveryFolder.java", "ResidentServer.java");
        }
    }

    private static String read(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Test
    void program_onlyEditorUsesJavaFx() {
        ArchitectureRules.onlyEditorUsesJavaFx().check(PROGRAM);
    }

    @Test
    void program_onlyCommandsPrint() {
        ArchitectureRules.onlyCommandsPrint().check(PROGRAM);
    }

    @Test
    void program_checkedExceptionsAreUserFacing() {
        ArchitectureRules.checkedExceptionsAreUserFacing().check(PROGRAM);
    }

    @Test
    void internalCheckedException_isReported() throws IOException {
        assertReported(ArchitectureRules.checkedExceptionsAreUserFacing(), "checked exceptions are user-facing",
                "package lightning.format.mesh; class Bad extends Exception {}");
    }

    @Test
    void program_opensUserFilesInOneClass() {
        ArchitectureRules.userFilesAreOpenedByOneClass().check(PROGRAM);
    }

    @Test
    void uncheckedFileOpen_isReported() throws IOException {
        assertReported(ArchitectureRules.userFilesAreOpenedByOneClass(), "only RegularFile opens files named by users",
                "package lightning.format.mesh; class Bad { Object in(java.nio.file.Path file) throws java.io.IOException {"
                        + " return java.nio.file.Files.newInputStream(file); } }");
        assertReported(ArchitectureRules.userFilesAreOpenedByOneClass(), "only RegularFile opens files named by users",
                "package lightning.format.mesh; class Bad { Object in(String file) throws java.io.IOException {"
                        + " return new java.io.FileInputStream(file); } }");
    }

    @Test
    void referenceTracer_isIndependent() {
        ImportOption program = ImportOption.Predefined.DO_NOT_INCLUDE_TESTS;
        JavaClasses withOracle = new ClassFileImporter()
                .withImportOption(location -> program.includes(location) || location.contains("/lightning/render/shading/reference/"))
                .importPackages("lightning");
        assertThat(withOracle.contain("lightning.render.shading.reference.ReferenceTracer")).isTrue();
        ArchitectureRules.referenceTracerIsIndependent().check(withOracle);
    }

    @Test
    void program_methodsOf1998AreKnownByFew() {
        ArchitectureRules.methodsOf1998AreKnownByFew().check(PROGRAM);
    }

    @Test
    void otherUseOfAMethodOf1998_isReported() throws IOException {
        assertReported(ArchitectureRules.methodsOf1998AreKnownByFew(), "only the listed classes know the methods of 1998",
                "package lightning.render.relight.paper; public class Accuracy {}",
                "package lightning.document.loop; class Bad { lightning.render.relight.paper.Accuracy accuracy; }");
    }

    @Test
    void program_menusContainOnlyCommandItems() {
        ArchitectureRules.onlyCommandItemsCreateMenuItems().check(PROGRAM);
    }

    @Test
    void menuItemWithoutCommand_isReported() throws IOException {
        assertReported(ArchitectureRules.onlyCommandItemsCreateMenuItems(), "only CommandMenuItems creates menu items",
                "package javafx.scene.control; public class MenuItem {}",
                "package javafx.scene.control; public class RadioMenuItem extends MenuItem {}",
                "package lightning.editor.window.property; class Bad { Object item = new javafx.scene.control.RadioMenuItem(); }");
    }

    /** A table of which the tests change one row. */
    private static PackageTable table(String... rows) {
        return new PackageTable(Arrays.stream(rows).map(PackageTable.Row::parse).toList());
    }

    private JavaClasses sceneUsingMath() throws IOException {
        return compile("package lightning.base.math; public class Number {}",
                "package lightning.scene; class Thing { lightning.base.math.Number[] numbers; }");
    }

    @Test
    void allowedImport_isAllowed() throws IOException {
        PackageTable table = table("base.math:", "scene: base.math");
        assertThat(table.violations(sceneUsingMath())).isEmpty();
        assertThat(table.unused(sceneUsingMath())).isEmpty();
        assertThat(table.forwardImports()).isEmpty();
    }

    @Test
    void otherImport_isReportedWithTheRow() throws IOException {
        assertThat(table("base.math:", "scene:").violations(sceneUsingMath())).singleElement().asString()
                .startsWith("package scene imports base.math,").contains("Thing → Number").endsWith("\n    scene: base.math");
    }

    @Test
    void unusedImport_isReportedWithTheRow() throws IOException {
        PackageTable table = table("base.math:", "base.text:", "scene: base.math base.text", "scene.shot:");
        assertThat(table.unused(sceneUsingMath())).containsExactly("package base.text is gone; remove its row",
                "package scene does not import base.text; the row is\n    scene: base.math", "package scene.shot is gone; remove its row");
    }

    @Test
    void packageWithoutRow_isReportedWithTheRow() throws IOException {
        assertThat(table("base.math:").violations(sceneUsingMath())).singleElement().asString()
                .startsWith("package scene has no row").endsWith("\n    scene: base.math");
    }

    @Test
    void packageUsingMain_isReported() throws IOException {
        JavaClasses classes =
                compile("package lightning; public class Main {}", "package lightning.cli; class Bad { lightning.Main main; }");
        assertThat(PACKAGES.violations(classes)).singleElement().asString().startsWith("package cli imports (root),");
    }

    @Test
    void rowsInWrongOrder_areReported() {
        assertThat(table("scene: base.math", "base.math:", "util:").forwardImports()).containsExactly("scene → base.math");
        assertThat(table("scene: base.math", "base.math:", "util:").outOfOrder()).containsExactly("base.math", "util");
    }

    @Test
    void javaFxOutsideEditor_isReported() throws IOException {
        assertReported(ArchitectureRules.onlyEditorUsesJavaFx(), "only lightning.editor.window sees JavaFX",
                "package javafx.scene; public class Node {}",
                "package lightning.document; class Bad { javafx.scene.Node node; }");
    }

    @Test
    void printInEngine_isReported() throws IOException {
        assertReported(ArchitectureRules.onlyCommandsPrint(), "print",
                "package lightning.render.relight; class Bad { void say() { System.out.println(); } }");
    }

    @Test
    void printInCommand_isAllowed() throws IOException {
        JavaClasses classes = compile(
                "package lightning.cli; class Good { void say() { System.err.println(); } }");
        assertThatCode(() -> ArchitectureRules.onlyCommandsPrint().check(classes)).doesNotThrowAnyException();
    }

    @Test
    void referenceTracerUsingFastCodeIndirectly_isReported() throws IOException {
        assertReported(ArchitectureRules.referenceTracerIsIndependent(), "the reference tracer uses no cache",
                "package lightning.render.trace.solid; public class SphereLanes {}",
                "package lightning.render.trace; public class Nearest { lightning.render.trace.solid.SphereLanes lanes; }",
                "package lightning.render.shading.reference; class ReferenceTracer { lightning.render.trace.Nearest nearest; }");
    }

    @Test
    void referenceTracerUsingEngine_isReported() throws IOException {
        assertReported(ArchitectureRules.referenceTracerIsIndependent(), "the reference tracer uses no cache",
                "package lightning.render.engine; public class EngineWorkers {}",
                "package lightning.render.shading.reference; class ReferenceTracer { lightning.render.engine.EngineWorkers workers; }");
    }

    @Test
    void referenceTracerUsingBvh_isReported() throws IOException {
        assertReported(ArchitectureRules.referenceTracerIsIndependent(), "tests every shape, without a BVH",
                "package lightning.render.trace.tree; public class Bvh {}",
                "package lightning.render.shading.reference; class ReferenceTracer { lightning.render.trace.tree.Bvh bvh; }");
    }

    @Test
    void referenceTracerUsingCache_isReported() throws IOException {
        assertReported(ArchitectureRules.referenceTracerIsIndependent(), "the reference tracer uses no cache",
                "package lightning.render.cache; public class Rows {}",
                "package lightning.render.shading.reference; class ReferenceTracer { void use() { new lightning.render.cache.Rows(); } }");
    }

    private void assertReported(ArchRule rule, String sentence, String... sources) throws IOException {
        JavaClasses classes = compile(sources);
        assertThatThrownBy(() -> rule.check(classes))
                .isInstanceOf(AssertionError.class)
                .hasMessageContaining(sentence);
    }

    /** Compiles classes, each given as its source on one line, in a separate folder. */
    private JavaClasses compile(String... sources) throws IOException {
        var compiler = ToolProvider.getSystemJavaCompiler();
        List<Path> files = new ArrayList<>();
        for (String source : sources) {
            String type = source.replaceFirst(".*?class (\\w+) .*", "$1");
            Path file = folder.resolve("source" + files.size()).resolve(type + ".java");
            Files.createDirectories(file.getParent());
            files.add(Files.writeString(file, source));
        }
        Path classes = folder.resolve("classes");
        var messages = new StringWriter();
        try (var manager = compiler.getStandardFileManager(null, null, null)) {
            boolean compiled = compiler.getTask(messages, manager, null,
                    List.of("-proc:none", "-cp", folder.toString(), "-d", classes.toString()), null,
                    manager.getJavaFileObjectsFromPaths(files)).call();
            assertThat(compiled).as(messages.toString()).isTrue();
        }
        return new ClassFileImporter().importPath(classes);
    }
}
