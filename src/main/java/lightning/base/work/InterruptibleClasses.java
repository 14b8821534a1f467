package lightning.base.work;

import java.io.IOException;
import java.io.InputStream;
import java.lang.classfile.ClassFile;
import java.lang.classfile.ClassHierarchyResolver;
import java.lang.classfile.ClassTransform;
import java.lang.classfile.CodeBuilder;
import java.lang.classfile.CodeElement;
import java.lang.classfile.CodeTransform;
import java.lang.classfile.Label;
import java.lang.classfile.instruction.BranchInstruction;
import java.lang.classfile.instruction.LabelTarget;
import java.lang.constant.ClassDesc;
import java.lang.constant.ConstantDescs;
import java.lang.constant.MethodTypeDesc;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * Copies of classes whose loops end when their thread is interrupted. For code of others that may never end: before each jump back, it
 * throws an {@link Error} if the thread is interrupted.
 */
public final class InterruptibleClasses extends ClassLoader {
    private static final ClassDesc THREAD = ClassDesc.of("java.lang.Thread");
    private static final ClassDesc ERROR = ClassDesc.of("java.lang.Error");

    private final ClassLoader original;
    private final List<String> prefixes;

    /**
     * @param original loads the classes that are copied, and all others
     * @param prefixes starts of the names of classes to copy
     */
    public InterruptibleClasses(ClassLoader original, String... prefixes) {
        super(original);
        this.original = original;
        this.prefixes = List.of(prefixes);
    }

    @Override
    protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
        if (prefixes.stream().noneMatch(name::startsWith)) {
            return super.loadClass(name, resolve);
        }
        synchronized (getClassLoadingLock(name)) {
            Class<?> loaded = findLoadedClass(name);
            return loaded != null ? loaded : copy(name);
        }
    }

    private Class<?> copy(String name) throws ClassNotFoundException {
        Class<?> source = Class.forName(name, false, original);
        try (InputStream in = source.getResourceAsStream(name.substring(name.lastIndexOf('.') + 1) + ".class")) {
            if (in == null) {
                throw new ClassNotFoundException(name);
            }
            ClassFile classes = ClassFile.of(ClassFile.ClassHierarchyResolverOption.of(ClassHierarchyResolver.ofClassLoading(original)));
            byte[] copy = classes.transformClass(classes.parse(in.readAllBytes()),
                    ClassTransform.transformingMethodBodies(CodeTransform.ofStateful(LoopChecks::new)));
            return defineClass(name, copy, 0, copy.length);
        } catch (IOException e) {
            throw new ClassNotFoundException(name, e);
        }
    }

    /** Adds a check before each jump to a label that came before. */
    private static final class LoopChecks implements CodeTransform {
        private final Set<Label> passed = new HashSet<>();

        @Override
        public void accept(CodeBuilder code, CodeElement element) {
            if (element instanceof LabelTarget target) {
                passed.add(target.label());
            } else if (element instanceof BranchInstruction branch && passed.contains(branch.target())) {
                code.invokestatic(THREAD, "currentThread", MethodTypeDesc.of(THREAD))
                        .invokevirtual(THREAD, "isInterrupted", MethodTypeDesc.of(ConstantDescs.CD_boolean))
                        .ifThen(block -> block.new_(ERROR).dup().loadConstant("interrupted")
                                .invokespecial(ERROR, ConstantDescs.INIT_NAME,
                                        MethodTypeDesc.of(ConstantDescs.CD_void, ConstantDescs.CD_String))
                                .athrow());
            }
            code.with(element);
        }
    }
}
