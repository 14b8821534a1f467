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
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.tools.ToolProvider;
import lightning.sample.Slow;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Checks that the program follows {@link ArchitectureRules}, and that the rules detect violations. */
@Slow
class ArchitectureTest {
    private static final JavaClasses PROGRAM = new ClassFileImporter()
            .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
            .importPackages("lightning");

    @TempDir
    private Path folder;

    @Test
    void program_isImported() {
        assertThat(PROGRAM.contain("lightning.Main")).isTrue();
        assertThat(PROGRAM.contain("lightning.scene.Scene")).isTrue();
        assertThat(PROGRAM.contain("lightning.ArchitectureTest")).isFalse();
    }

    @Test
    void program_layersDependOnlyOnLowerLayers() {
        ArchitectureRules.layersDependOnlyOnLowerLayers().check(PROGRAM);
    }

    @Test
    void layers_haveNoForwardDependencies() {
        assertThat(ArchitectureRules.layersWithForwardDependency()).isEmpty();
    }

    @Test
    void layers_areInGroupOrder() {
        assertThat(ArchitectureRules.layersOutOfOrder()).isEmpty();
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
    void program_referenceTracerIsIndependent() {
        ArchitectureRules.referenceTracerIsIndependent().check(PROGRAM);
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

    @Test
    void lowerLayerUsingHigher_isReported() throws IOException {
        assertReported(ArchitectureRules.layersDependOnlyOnLowerLayers(), "lightning.base.math depends only on rows above it",
                "package lightning.scene; public class Thing {}",
                "package lightning.base.math; class Bad { lightning.scene.Thing thing; }");
    }

    @Test
    void undeclaredDependency_isReported() throws IOException {
        assertReported(ArchitectureRules.layersDependOnlyOnLowerLayers(), "lightning.render.image depends only on rows above it",
                "package lightning.scene; public class Thing {}",
                "package lightning.render.image; class Bad { lightning.scene.Thing thing; }");
    }

    @Test
    void commandUsingEditor_isReported() throws IOException {
        assertReported(ArchitectureRules.layersDependOnlyOnLowerLayers(), "lightning.cli depends only on rows above it",
                "package lightning.editor.window; public class Window {}",
                "package lightning.cli; class Bad { lightning.editor.window.Window window; }");
    }

    @Test
    void planUsingTiles_isReported() throws IOException {
        assertReported(ArchitectureRules.layersDependOnlyOnLowerLayers(), "lightning.render.relight.plan depends only on rows above it",
                "package lightning.render.relight.tile; public class Worker {}",
                "package lightning.render.relight.plan; class Bad { lightning.render.relight.tile.Worker worker; }");
    }

    @Test
    void paneUsingOtherPane_isReported() throws IOException {
        assertReported(ArchitectureRules.layersDependOnlyOnLowerLayers(), "lightning.editor.window.traced depends only on rows above it",
                "package lightning.editor.window.preview; public class Pane {}",
                "package lightning.editor.window.traced; class Bad { lightning.editor.window.preview.Pane pane; }");
    }

    @Test
    void packageUsingMain_isReported() throws IOException {
        assertReported(ArchitectureRules.layersDependOnlyOnLowerLayers(), "lightning.cli depends only on rows above it",
                "package lightning; public class Main {}",
                "package lightning.cli; class Bad { lightning.Main main; }");
    }

    @Test
    void packageWithoutLayer_isReported() throws IOException {
        assertReported(ArchitectureRules.layersDependOnlyOnLowerLayers(), "is in a package that has a row",
                "package lightning.util; class Bad {}");
    }

    @Test
    void higherLayerUsingLower_isAllowed() throws IOException {
        JavaClasses classes = compile("package lightning.base.math; public class Number {}",
                "package lightning.render.trace; class Good { lightning.base.math.Number number; }");
        assertThatCode(() -> ArchitectureRules.layersDependOnlyOnLowerLayers().check(classes)).doesNotThrowAnyException();
    }

    @Test
    void javaFxOutsideEditor_isReported() throws IOException {
        assertReported(ArchitectureRules.onlyEditorUsesJavaFx(), "only lightning.editor.window sees JavaFX",
                "package javafx.scene; public class Node {}",
                "package lightning.editor.document; class Bad { javafx.scene.Node node; }");
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
