package lightning;

import static com.tngtech.archunit.base.DescribedPredicate.not;
import static com.tngtech.archunit.core.domain.JavaCall.Predicates.target;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.assignableTo;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.core.domain.properties.HasName.Predicates.nameMatching;
import static com.tngtech.archunit.core.domain.properties.HasOwner.Predicates.With.owner;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.lang.CompositeArchRule;
import com.tngtech.archunit.library.GeneralCodingRules;
import java.io.FileInputStream;
import java.io.FileReader;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import lightning.base.text.UserFacingException;

/** Rules of the architecture besides the imports of packages, which {@link PackageTable} has. */
final class ArchitectureRules {
    /** The reference tracer: the oracle of every equality test, kept simple enough to trust. */
    private static final String REFERENCE =
            "lightning\\.render\\.shading\\.reference\\.Reference(Tracer|Indirect|GatherPoints|GatherRay|PointLight)(\\$.*)?";

    /** Types outside their package that know the methods of 1998: at most twelve. */
    private static final String METHODS_OF_1998 =
            "lightning\\.(render\\.RenderOptions(Builder)?|render\\.relight\\.tile\\.BounceLevels"
                    + "|render\\.measure\\.AccuracySetting|editor\\.window\\.model\\.AccuracyMode|cli\\.option\\.(UpdateOptions|ReflectionsOption)"
                    + "|bench\\.(DriftBench|result\\.DriftPoint|report\\.(PlotColor|CurveSections)))(\\$.*)?";

    private ArchitectureRules() {}

    static ArchRule onlyEditorUsesJavaFx() {
        return noClasses().that(not(resideInAPackage(packageOf("editor.window"))))
                .should().dependOnClassesThat().resideInAnyPackage("javafx..", "com.sun.javafx..")
                .as("only lightning.editor.window sees JavaFX")
                .allowEmptyShould(true);
    }

    /** Menu items are created only from commands. Submenus and separators have no action. */
    static ArchRule onlyCommandItemsCreateMenuItems() {
        return noClasses().that(not(nameMatching("lightning\\.editor\\.window\\.command\\.CommandMenuItems")))
                .should().callConstructorWhere(target(owner(assignableTo("javafx.scene.control.MenuItem")
                        .and(not(nameMatching("javafx\\.scene\\.control\\.(Menu|SeparatorMenuItem)").forSubtype())))))
                .as("only CommandMenuItems creates menu items")
                .allowEmptyShould(true);
    }

    static ArchRule onlyCommandsPrint() {
        return noClasses().that(not(resideInAnyPackage(packageOf("cli"), packageOf("bench")).or(resideInAPackage("lightning"))))
                .should(GeneralCodingRules.ACCESS_STANDARD_STREAMS)
                .as("only lightning.cli, lightning.bench and lightning.Main print")
                .allowEmptyShould(true);
    }

    /**
     * Opening a pipe may block forever, and some devices never end, so one class opens all files named by users or their files. The other
     * listed classes read files that the program wrote, or found to be regular.
     */
    static ArchRule userFilesAreOpenedByOneClass() {
        DescribedPredicate<JavaClass> own =
                resideInAnyPackage(packageOf("base.file"), packageOf("shot.cluster"), packageOf("bench"), packageOf("format.pov"))
                        .or(nameMatching(".*\\.(RecoveryFolder|OpenSceneRegistry|SceneSaver|Preferences)"));
        return CompositeArchRule
                .of(noClasses().that(not(own))
                        .should().callMethodWhere(target(owner(assignableTo(Files.class)))
                                .and(target(nameMatching("newInputStream|newBufferedReader|readAll.*|readString|lines|copy|mismatch"))))
                        .as("only RegularFile opens files named by users")
                        .allowEmptyShould(true))
                .and(noClasses().that(not(own))
                        .should().callConstructorWhere(target(owner(assignableTo(FileInputStream.class)
                                .or(assignableTo(RandomAccessFile.class)).or(assignableTo(FileReader.class)))))
                        .as("only RegularFile opens files named by users")
                        .allowEmptyShould(true));
    }

    /** The methods of 1998 are choices of the options, the editor, the command line and the benchmark. Everything else asks the options. */
    static ArchRule methodsOf1998AreKnownByFew() {
        return noClasses().that(not(resideInAPackage("lightning.render.relight.paper")).and(not(nameMatching(METHODS_OF_1998))))
                .should().dependOnClassesThat().resideInAPackage("lightning.render.relight.paper")
                .as("only the listed classes know the methods of 1998")
                .allowEmptyShould(true);
    }

    /** Checked exceptions reach the user and must not look like internal errors. */
    static ArchRule checkedExceptionsAreUserFacing() {
        return classes()
                .that(assignableTo(Exception.class).and(not(assignableTo(RuntimeException.class)))
                        .and(not(assignableTo(IOException.class))))
                .should().beAssignableTo(UserFacingException.class)
                .as("checked exceptions are user-facing")
                .allowEmptyShould(true);
    }

    /**
     * The oracle stays independent of the tested code. Through its helpers it uses no kernel and no cache; it never uses the BVH, which a
     * scene's geometry holds for the kernels.
     */
    static ArchRule referenceTracerIsIndependent() {
        return CompositeArchRule
                .of(noClasses().that(nameMatching(REFERENCE))
                        .should().transitivelyDependOnClassesThat(resideInAnyPackage(packageOf("render.cache"),
                                packageOf("render.relight"), packageOf("render.engine")).or(kernel(".*(Packet|Lanes).*")))
                        .as("the reference tracer uses no cache, relighting, engine or fast kernel")
                        .allowEmptyShould(true))
                .and(noClasses().that(nameMatching(REFERENCE))
                        .should().dependOnClassesThat(kernel(".*Bvh.*"))
                        .as("the reference tracer tests every shape, without a BVH")
                        .allowEmptyShould(true));
    }

    private static DescribedPredicate<JavaClass> kernel(String name) {
        return resideInAPackage(packageOf("render.trace")).and(nameMatching(name));
    }

    private static String packageOf(String row) {
        return "lightning." + row + "..";
    }
}
