// SPDX-License-Identifier: BSD-3-Clause
#include "module.hpp"
#include "brinell/devices.hpp"

#include "brinell/foundation/error.hpp"
#include "brinell/foundation/processor.hpp"
#include "brinell/io/member_keys.hpp"
#include "brinell/io/printable.hpp"

#include <new>

namespace nb = nanobind;

namespace
{

/// Raises the Python exception of the same name, from brinell.errors.
void raise(const char* name, const char* text)
{
  const nb::object type = nb::module_::import_("brinell.errors").attr(name);
  PyErr_SetString(
      type.ptr(),
      brinell::io::printable(brinell::io::with_keys(text)).c_str()); // other bytes would leave an empty message
}

void translate(const std::exception_ptr& pointer, void* /*payload*/)
{
  try
  {
    std::rethrow_exception(pointer);
  }
  catch (const brinell::GridError& error)
  {
    raise("GridError", error.what());
  }
  catch (const brinell::InputError& error)
  {
    raise("InputError", error.what());
  }
  catch (const brinell::ConvergenceError& error)
  {
    raise("ConvergenceError", error.what());
  }
  catch (const brinell::IoError& error)
  {
    raise("IoError", error.what());
  }
  catch (const brinell::DeviceError& error)
  {
    raise("DeviceError", error.what());
  }
  catch (const brinell::InternalError& error)
  {
    raise("InternalError", error.what());
  }
}

} // namespace

NB_MODULE(_core, m)
{
  // Better than to be killed for an illegal instruction.
#if defined(__AVX512F__)
  if (__builtin_cpu_supports("avx512f") == 0)
    throw nb::import_error("brinell was compiled for a processor with AVX-512; build it for this one: pip install .");
#elif defined(__AVX2__)
  if (__builtin_cpu_supports("avx2") == 0)
    throw nb::import_error("brinell was compiled for a processor with AVX2; build it for this one: pip install .");
#endif
  brinell::require_processor_choice();
  brinell::app::offer_devices();
  nb::register_exception_translator(translate);
  brinell::python::bind_app(m);
  brinell::python::bind_stepping(m);
  brinell::python::bind_reference(m);
  brinell::python::bind_green(m);
  brinell::python::bind_constitutive(m);
  brinell::python::bind_halfspace(m);
  brinell::python::bind_heat(m);
  brinell::python::bind_contact(m);
  brinell::python::bind_elastoplastic(m);
  brinell::python::bind_textures(m);
  brinell::python::bind_curves(m);
  m.def("chosen_processor", &brinell::chosen_processor);
  m.def("compiled_processors", &brinell::compiled_processors);
}
