#include "render/program.h"

#include <gmock/gmock.h>

#include "blender/renderer.h"
#include "core/error.h"
#include "fake_renderer.h"
#include "povray/renderer.h"
#include "render/command.h"
#include "render/renderer_program.h"

/// Which program makes the pictures, and what it says it is.
namespace wold::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// An environment of the test's own.
class Programs : public FakeRenderer {
 protected:
  Programs() {
    make_folder(folder_ / "bin");
    ::setenv("PATH", (folder_ / "bin").c_str(), 1);
    ::unsetenv("WOLD_BLENDER");
  }
  ~Programs() override {
    ::setenv("PATH", path_.c_str(), 1);
    ::unsetenv("WOLD_BLENDER");
    ::unsetenv("PYTHONPATH");
  }

  /// A script that says one line, whatever it is asked.
  fs::path says(const std::string& name, const std::string& line) const {
    return write_program(name, "#!/bin/sh\necho '" + line + "'\n");
  }

  static render::FoundProgram find(const std::string& chosen = {}) {
    return render::find_renderer(blender::renderer(), chosen);
  }

  static std::string error_of(const std::function<void()>& body) {
    try {
      body();
    } catch (const RendererError& error) {
      return error.what();
    }
    return "no error";
  }

  std::string refusal(const fs::path& program) const {
    return error_of([&] { render::recognise(blender::renderer(), {program, "--blender"}, never); });
  }

  /// A Python of its own, without any packages; skips the test where there is none to copy.
  fs::path make_python() const {
    const fs::path here = folder_ / "python";
    const std::string command = "PATH='" + path_ + "' python3 -m venv --without-pip '" +
                                here.string() + "' && PATH='" + path_ + "' find '" + here.string() +
                                "' -name site-packages > '" + (folder_ / "site").string() + "'";
    EXPECT_EQ(std::system(command.c_str()), 0);
    return here / "bin/python3";
  }
  fs::path site_packages() const {
    std::string place = read_file(folder_ / "site");
    return place.substr(0, place.find('\n'));
  }

  std::string path_ = std::getenv("PATH");
};

TEST_F(Programs, TheOptionIsStrongerThanTheVariableAndThatThanThePath) {
  const fs::path on_path = says("bin/blender", "");
  const fs::path by_variable = says("variable.sh", "");
  const fs::path by_option = says("option.sh", "");
  EXPECT_EQ(find().path, on_path);
  EXPECT_EQ(find().chosen_by, "PATH");
  ::setenv("WOLD_BLENDER", by_variable.c_str(), 1);
  EXPECT_EQ(find().path, by_variable);
  EXPECT_EQ(find().chosen_by, "WOLD_BLENDER");
  EXPECT_EQ(find(by_option.string()).path, by_option);
  EXPECT_EQ(find(by_option.string()).chosen_by, "--blender");
}

TEST_F(Programs, MayBeNamedAsOnThePath) {
  const fs::path newer = says("bin/blender-5.2", "");
  EXPECT_EQ(find("blender-5.2").path, newer);
  ::setenv("WOLD_BLENDER", "blender-5.2", 1);
  EXPECT_EQ(find().path, newer);
  EXPECT_THAT(error_of([] { find("blender-6"); }), HasSubstr("--blender names blender-6"));
}

TEST_F(Programs, MissingOnesSayWhatToInstall) {
  EXPECT_THAT(error_of([] { find(); }), HasSubstr("apt-get install blender"));
  ::setenv("WOLD_BLENDER", (folder_ / "nothing").c_str(), 1);
  EXPECT_THAT(error_of([] { find(); }), HasSubstr("WOLD_BLENDER names " + folder_.string()));
}

TEST_F(Programs, SayTheirVersion) {
  // What wrappers print before it does no harm.
  const fs::path wrapped = write_program(
      "wrapped.sh", "#!/bin/sh\necho loading modules\necho 'Blender 5.2.2 LTS'\necho '\tbuild'\n");
  const auto blender = render::recognise(blender::renderer(), {wrapped, "PATH"}, never);
  EXPECT_EQ(blender.version, "5.2.2");
  EXPECT_EQ(blender.form, render::ProgramForm::itself);
  const fs::path povray = says("povray.sh", "POV-Ray 3.8.0-beta.2.unofficial");
  EXPECT_EQ(render::recognise(povray::renderer(), {povray, "PATH"}, never).version,
            "3.8.0-beta.2.unofficial");
}

TEST_F(Programs, OtherOnesAreNamed) {
  EXPECT_THAT(refusal(says("other.sh", "true (GNU coreutils) 9.1")),
              AllOf(HasSubstr("--blender names " + (folder_ / "other.sh").string()),
                    HasSubstr("not Blender and no Python"), HasSubstr("GNU coreutils")));
  const fs::path blender = says("blender.sh", "Blender 5.2.2");
  EXPECT_THAT(error_of([&] {
                render::recognise(povray::renderer(), {blender, "WOLD_POVRAY"}, never);
              }),
              HasSubstr("which is not POV-Ray"));
}

TEST_F(Programs, APythonIsRecognisedByItsPackageBpy) {
  const fs::path python = make_python();
  EXPECT_THAT(refusal(python), AllOf(HasSubstr("without the package bpy"),
                                     HasSubstr(python.string() + " -m pip install bpy")));
  make_folder(site_packages() / "bpy");
  make_folder(site_packages() / "bpy-9.8.7.dist-info");
  write_file(site_packages() / "bpy/__init__.py", "raise SystemExit('bpy was loaded')\n");
  write_file(site_packages() / "bpy-9.8.7.dist-info/METADATA",
             "Metadata-Version: 2.1\nName: bpy\nVersion: 9.8.7\n");
  const auto program = render::recognise(blender::renderer(), {python, "--blender"}, never);
  EXPECT_EQ(program.form, render::ProgramForm::python);
  EXPECT_EQ(program.version, "9.8.7");
  EXPECT_EQ(program.module, site_packages() / "bpy/__init__.py");
  EXPECT_EQ(program.found.path, python) << "its link leads to the system's Python";
  EXPECT_THAT(program.python, HasSubstr("3."));
}

TEST_F(Programs, APythonTakesNothingFromTheEnvironment) {
  const fs::path python = make_python();
  make_folder(folder_ / "other");
  write_file(folder_ / "other/bpy.py", "");
  ::setenv("PYTHONPATH", (folder_ / "other").c_str(), 1);
  EXPECT_THAT(refusal(python), HasSubstr("without the package bpy"));
}

TEST_F(Programs, APythonRunsTheLauncherAndImportsOnlyWhatIsBesideIt) {
  render::Job job = this->job();
  job.program.found.path = make_python();
  job.program.form = render::ProgramForm::python;
  write_file(folder_ / "scene/json.py", "raise SystemExit('data were run')\n");
  write_file(job.program.launcher,
             "import json, os, sys\n"
             "print(os.getcwd(), sys.dont_write_bytecode, sys.argv[1:4])\nsys.exit(1)\n");
  EXPECT_THAT(failure_of<RendererError>(job),
              AllOf(HasSubstr("/ True ['--', '" + (folder_ / "scene").string() + "', '3']"),
                    Not(HasSubstr("data were run"))));
}

}  // namespace
}  // namespace wold::test
